% BLINDHANDOVER  Writes what the laboratory hands over, and seals the truth.
%
% CALL: blindHandOver (STEM, SEALED, LAB, TRUTHS, Z)
%
%   STEM    path without ending: STEM-cases.csv gets the measured values and
%           their standard uncertainty, STEM-lists.csv the effects to ask for,
%           STEM-truth.sha256 the digest of the truth
%   SEALED  path of the truth, outside of the repository
%   LAB     struct of blindLab;  TRUTHS  1 x N struct of blindDraw
%   Z       1 x N cell of trials x T, results of the truth (blindRun)
%
% A value is the mean of the trials, each with a reading error; empty where a
% trial gave none.
%
% See also: blind, blindCases

function blindHandOver (stem, sealed, lab, truths, Z)
  writeAtomic (sealed, truthText (lab, truths, Z));
  [~, digest] = system (sprintf ('sha256sum < "%s"', sealed));
  writeAtomic ([stem, '-truth.sha256'], [strtok(digest), "\n"]);
  cases = {'case,model,name,value,sd,repeats,role'};
  lists = {'case,effects'};
  problem = lab.problem;
  names = {problem.effects.name};
  for i = 1:numel (truths)
    y = mean (Z{i} + truths(i).noise .* lab.sd, 1);
    for t = 1:numel (y)
      value = '';
      if isfinite (y(t))
        value = sprintf ('%.6g', y(t));
      end
      role = 'calibrate';
      if problem.held(t)
        role = 'holdout';
      end
      cases{end + 1} = sprintf ...
        ('%d,%s,%s,%s,%.6g,%d,%s', truths(i).number, ...
         problem.benchNames{problem.bench(t)}, ...
         problem.targetNames{t}, ...
         value, lab.sd(t) / sqrt (lab.trials), lab.trials, role);
    end
    list = names(~strcmp (names, truths(i).removed));
    lists{end + 1} = sprintf ('%d,%s', truths(i).number, strjoin (list, ' '));
  end
  writeTable ([stem, '-cases.csv'], cases);
  writeTable ([stem, '-lists.csv'], lists);
end

function text = truthText (lab, truths, Z)
  problem = lab.problem;
  lines = {['case,class,cause,forms,removed,phi,level,halfStep,', ...
            strjoin(problem.names, ','), ',seeds,', ...
            strjoin(problem.targetNames, ',')]};
  for i = 1:numel (truths)
    t = truths(i);
    X = problem.limits(1, :) + t.theta .* diff (problem.limits);
    lines{end + 1} = sprintf ...
      ('%d,%s,%s,%s,%s,%s,%g,%d,%s,%s,%s', t.number, t.class, ...
       strjoin (t.cause, ' '), strjoin (t.forms, ' '), t.removed, ...
       strtrim (sprintf ('%.4g ', t.phi)), t.level, t.halfStep, ...
       strjoin (arrayfun (@(x) sprintf ('%.6g', x), X, ...
                          'UniformOutput', false), ','), ...
       strtrim (sprintf ('%d ', t.seeds)), ...
       strjoin (arrayfun (@(z) sprintf ('%.6g', z), mean (Z{i}, 1), ...
                          'UniformOutput', false), ','));
  end
  text = [strjoin(lines, "\n"), "\n"];
end
