% WRITEGAPTABLES  Writes the tables of a diagnosis as CSV files in gap/.
%
% CALL: writeGapTables (DIAGNOSIS, CASE)
%
%   DIAGNOSIS  of diagnoseMatrices
%   CASE       struct with the field folder
%
% targets.csv    deviation of each target, what parameters can hide, noise
% effects.csv    each effect: what is needed to see it, probability, strength
% cosines.csv    how alike two effects look (isolability)
% conflicts.csv  p-value of a bench (column) predicted from another (row)
% next.csv       further measurements by what they would tell
%
% See also: diagnoseGap, writeGapJson

function writeGapTables (diagnosis, Case)
  folder = fullfile (Case.folder, 'gap');
  [~, ~] = mkdir (folder);
  put = @(name, lines) writeAtomic (fullfile (folder, name), ...
                                    [strjoin(lines, "\n"), "\n"]);
  put ('targets.csv', targetLines (diagnosis));
  put ('effects.csv', effectLines (diagnosis));
  names = diagnosis.screen.names;
  put ('cosines.csv', matrixLines (names, diagnosis.screen.cosine));
  conflict = diagnosis.where.conflict;
  put ('conflicts.csv', ...
       matrixLines (diagnosis.problem.benchNames(conflict.bench), ...
                    conflict.pair));
  lines = {'test,gain_bits,cost,gain_per_cost'};
  for t = diagnosis.next(:)'
    lines{end + 1} = sprintf ('"%s",%.4g,%.4g,%.4g', t.test, t.gain, ...
                              t.cost, t.gainPerCost);
  end
  put ('next.csv', lines);
end

function lines = targetLines (diagnosis)
  problem = diagnosis.problem;
  where = diagnosis.where;
  budget = where.budget;
  lines = {['model,target,role,measured,predicted,residual,z,p,', ...
            'absorbability,blind,sd_measured,sd_trial,sd_surrogate']};
  for i = 1:numel (problem.used)
    t = problem.used(i);
    lines{end + 1} = sprintf (['%s,%s,calibrate,%.10g,%.10g,%.4g,%.3f,', ...
                               '%.4g,%.3f,%d,%.4g,%.4g,%.4g'], ...
                              problem.benchNames{problem.bench(t)}, ...
                              problem.targetNames{t}, problem.y(t), ...
                              problem.y(t) - where.residual(i), ...
                              where.residual(i), where.t(i), ...
                              where.pTarget(i), where.absorbability(i), ...
                              where.blind(i), budget.measurement(t), ...
                              budget.trial(t), budget.surrogate(t));
  end
  for i = 1:numel (problem.heldOut)
    t = problem.heldOut(i);
    lines{end + 1} = sprintf (['%s,%s,holdout,%.10g,%.10g,%.4g,%.3f,', ...
                               '%.4g,,,%.4g,%.4g,%.4g'], ...
                              problem.benchNames{problem.bench(t)}, ...
                              problem.targetNames{t}, problem.y(t), ...
                              where.held.mean(i), ...
                              problem.y(t) - where.held.mean(i), ...
                              where.held.z(i), ...
                              2 * normalTail (abs (where.held.z(i))), ...
                              budget.measurement(t), budget.trial(t), ...
                              budget.surrogate(t));
  end
end

function lines = effectLines (diagnosis)
  screen = diagnosis.screen;
  w = diagnosis.which;
  lines = {['effect,probability,strength,lo90,hi90,signal_to_noise,', ...
            'smallest_seen,absorbed_share,gain_chi2']};
  for k = 1:numel (screen.names)
    s = w.strength(k);
    name = matlab.lang.makeValidName (s.name);
    lines{end + 1} = sprintf ('%s,%.4g,%.4g,%.4g,%.4g,%.3g,%.3g,%.3f,%.4g', ...
                              s.name, w.posterior.(name), s.value, ...
                              s.interval90, screen.size(k), ...
                              screen.smallest(k), screen.absorbedShare(k), ...
                              screen.gain(k));
  end
end

function lines = matrixLines (names, M)
  lines = {strjoin([{''}, names], ',')};
  for i = 1:rows (M)
    lines{end + 1} = [names{i}, sprintf(',%.4g', M(i, :))];
  end
end
