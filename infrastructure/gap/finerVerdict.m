% FINERVERDICT  Whether a verdict would hold at the next finer level.
%
% CALL: LEVEL = finerVerdict (DATA, PROBLEM, GIVEN, OPTIONS, DIAGNOSIS)
%
%   DATA       plain runs at all levels, E n x v
%   PROBLEM    see newProblem
%   GIVEN      of gapProblemOf
%   OPTIONS    of gapBudget
%   DIAGNOSIS  of diagnoseMatrices, reached at the last level
%   LEVEL      [] where the case has no levels; else struct: variables (1 x v
%              cell), value and finer (1 x v: the last level, and one that is
%              finer by as much as the last is finer than the one before), shift
%              and shiftSd (1 x T: what going there is expected to do to the
%              responses at the calibrated set), verdict and effects (of a
%              diagnosis in which the model is moved by the shift and the
%              measurement is less sure by its deviation; '' where the levels
%              tell nothing of the finer one), holds (logical)
%
% How coarse the model is, is a gap of known cause. The runs of all levels say
% how it goes on; no run is made.

function level = finerVerdict (data, problem, given, options, diagnosis)
  level = [];
  if isempty (problem.coarse)
    return
  end
  data = keepRows (data, thinRuns (data, problem, 1000));
  values = problem.coarse.levels;
  level = struct ('variables', {problem.coarse.variables}, ...
                  'value', values(end, :), 'finer', nextFiner (values), ...
                  'shift', [], 'shiftSd', [], 'verdict', '', ...
                  'effects', {{}}, 'holds', false);
  surrogates = fitSurrogates (data, problem);
  for t = 1:numel (surrogates)
    [level.shift(t), level.shiftSd(t)] = ...
      levelShift (surrogates(t), diagnosis.where.params, ...
                  unitLevel (problem.coarse, level.finer, t));
  end
  if any (isnan (level.shift))
    return
  end
  given.value = given.value - level.shift;
  given.sd = sqrt (given.sd.^2 + level.shiftSd.^2);
  if ~isempty (given.covariance)
    given.covariance = given.covariance + diag (level.shiftSd.^2);
  end
  % the verdict is wanted, not what else a diagnosis tells
  [options.maxNewRuns, options.trials, options.bootstrap] = deal (0, 0, 1);
  there = diagnoseMatrices (given, diagnosis.data, options, []);
  level.verdict = there.which.verdict;
  level.effects = there.which.effects;
  level.holds = strcmp (level.verdict, diagnosis.which.verdict) && ...
                isequal (level.effects, diagnosis.which.effects);
end

% By the same ratio, of sizes; by the same step where a level is not above 0.
function finer = nextFiner (values)
  finer = 2 * values(end, :) - values(end - 1, :);
  isSize = all (values > 0, 1);
  ratio = values(end, isSize) ./ values(end - 1, isSize);
  finer(isSize) = values(end, isSize) .* ratio;
end
