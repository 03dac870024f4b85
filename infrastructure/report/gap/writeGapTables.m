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

function writeGapTables (diagnosis, Case)
  folder = fullfile (Case.folder, 'gap');
  [~, ~] = mkdir (folder);
  put = @(name, lines) writeAtomic (fullfile (folder, name), ...
                                    [strjoin(lines, "\n"), "\n"]);
  put ('targets.csv', targetLines (diagnosis));
  put ('effects.csv', effectLines (diagnosis));
  put ('cosines.csv', matrixLines (diagnosis.screen.names, ...
                                   diagnosis.screen.cosine));
  conflict = diagnosis.where.conflict;
  put ('conflicts.csv', ...
       matrixLines (diagnosis.gapProblem.benchNames(conflict.bench), ...
                    conflict.pair));
  put ('next.csv', [{'test,gain_bits,cost,gain_per_cost'}, ...
                    arrayfun(@nextLine, diagnosis.next(:)', ...
                             'UniformOutput', false)]);
end

function line = nextLine (t)
  line = sprintf ('"%s",%.4g,%.4g,%.4g', strrep (t.test, '"', '""'), ...
                  t.gain, t.cost, t.gainPerCost);
end

function lines = targetLines (diagnosis)
  budget = diagnosis.where.budget;
  lines = {['model,target,role,measured,predicted,residual,z,p,', ...
            'absorbability,blind,sd_measured,sd_trial,sd_surrogate']};
  for T = diagnosedTargets (diagnosis)
    hidden = ',';
    if strcmp (T.role, 'calibrate')
      hidden = sprintf ('%.3f,%d', T.absorbability, T.blind);
    end
    lines{end + 1} = sprintf (['%s,%.10g,%.10g,%.4g,%.3f,%.4g,%s,%.4g,', ...
                               '%.4g,%.4g'], ...
                              csvLine ({T.model, T.name, T.role}), ...
                              T.measured, T.predicted, T.residual, T.z, ...
                              T.p, hidden, budget.measurement(T.target), ...
                              budget.trial(T.target), ...
                              budget.surrogate(T.target));
  end
end

function lines = effectLines (diagnosis)
  screen = diagnosis.screen;
  w = diagnosis.which;
  lines = {['effect,probability,strength,lo90,hi90,signal_to_noise,', ...
            'smallest_seen,absorbed_share,gain_chi2']};
  for k = 1:numel (screen.names)
    s = w.strength(k);
    if isinf (screen.smallest(k)) || strcmp (s.says, 'nothing')
      s.interval90(:) = NaN;
    end
    name = matlab.lang.makeValidName (s.name);
    lines{end + 1} = sprintf ('%s,%.4g,%.4g,%.4g,%.4g,%.3g,%.3g,%.3f,%.4g', ...
                              csvLine ({s.name}), w.posterior.(name), ...
                              s.value, s.interval90, screen.size(k), ...
                              screen.smallest(k), screen.absorbedShare(k), ...
                              screen.gain(k));
  end
end

function lines = matrixLines (names, M)
  lines = {csvLine([{''}, names])};
  for i = 1:rows (M)
    lines{end + 1} = [csvLine(names(i)), sprintf(',%.4g', M(i, :))];
  end
end

%!test
%! % the tables of a small diagnosis are read back, whatever its names
%! [given, data, means] = smallGapLab ();
%! given.value = means ([0.4, 0.6], [0, 0, 0.6, 0, 0]);
%! given.benchNames = {'A, "old"', 'B', 'C'};
%! given.targetNames = [{'mass, "wet"'}, arrayfun(@(k) sprintf ('t%d', k), ...
%!                                                2:12, 'UniformOutput', 0)];
%! d = diagnoseMatrices (given, data, struct ('bootstrap', 49, ...
%!                                            'twins', 60));
%! d.next = struct ('test', 'do "x"', 'gain', 0.5, 'cost', 2, ...
%!                  'gainPerCost', 0.25);
%! Case.folder = tempname ();
%! mkdir (Case.folder);
%! writeGapTables (d, Case);
%! read = @(name) nthargout (1:2, @readCsvTable, ...
%!                           fullfile (Case.folder, 'gap', name));
%! targets = read ('targets.csv'){2};
%! assert (targets(1, 1:3), {'A, "old"', 'mass, "wet"', 'calibrate'});
%! assert (str2double (targets(:, 7))', d.where.t, 6e-4);
%! effects = read ('effects.csv'){2};
%! assert (effects(:, 1)', d.screen.names);
%! assert (str2double (effects(3, 2)), d.which.posterior.spread, 1e-3);
%! conflicts = read ('conflicts.csv');
%! assert (conflicts{1}(2), {'A, "old"'});
%! assert (read ('cosines.csv'){1}(2:end), d.screen.names);
%! assert (read ('next.csv'){2}, {'do "x"', '0.5', '2', '0.25'});
