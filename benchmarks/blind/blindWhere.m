% BLINDWHERE  Says anew where the gap of each sealed case lies, its truth open.
%
% CALL: blindWhere (STEM, LAB)
%
%   STEM  path without ending: STEM-cases.csv and STEM-answers.csv are read,
%         STEM-where-answers.csv written: the sealed answers with benches and
%         targets in the order of today's code
%   LAB   struct of blindLab; its surrogates stand in for those of the sealed
%         diagnosis, which had a campaign of its own
%
% After a mistake in locateGap was mended. No sealed answer: nothing but the
% order of benches and targets is new, and the truth was known.
%
% See also: blind, blindTable, locateGap

function blindWhere (stem, lab)
  rowsOf = tableRows ([stem, '-cases.csv']);
  [header, answers] = readCsvTable ([stem, '-answers.csv']);
  for i = 1:rows (answers)
    number = answers{i, strcmp(header, 'case')};
    measured = rowsOf(strcmp ({rowsOf.case}, number));
    [where, used] = whereOf (measured, lab);
    benches = lab.problem.benchNames([where.benches.bench]);
    targets = lab.problem.targetNames(used);
    [answers{i, strcmp(header, 'benches')}, ...
     answers{i, strcmp(header, 'targets')}] = ...
      blindPlaces (benches, [where.benches.size], targets, where.size);
  end
  lines = cellfun (@(k) strjoin (answers(k, :), ','), ...
                   num2cell (1:rows (answers)), 'UniformOutput', false);
  writeAtomic ([stem, '-where-answers.csv'], ...
               strjoin ([{strjoin(header, ',')}, lines, {''}], "\n"));
end

% USED  targets of the case that are calibrated on and were measured
function [where, used] = whereOf (measured, lab)
  problem = lab.problem;
  [isThere, row] = ismember (problem.targetNames, {measured.name});
  problem.value(:) = NaN;
  problem.value(isThere) = str2double ({measured(row(isThere)).value});
  used = problem.used(isfinite (problem.value(problem.used)));
  problem.used = used;
  options = setfield (lab.models.options, 'bootstrap', 199);
  study = struct ('problem', problem, 'em', lab.em);
  study.models = makeHypotheses (problem, withoutEffects (lab.em), options);
  study.fits = fitLibrary (study.models, problem.value(used));
  where = locateGap (study);
end
