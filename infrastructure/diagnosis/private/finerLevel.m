% FINERLEVEL  What one level finer than the last would do, to model and verdict.
%
% CALL: [GIVEN, JUDGE] = finerLevel (GIVEN, SURROGATES, DATA, PROBLEM)
%
%   GIVEN       of newProblem
%   SURROGATES  1 x T struct of fitSurrogates, of plain runs at all levels
%   DATA        these runs, E n x v
%   PROBLEM     see newProblem; it may have no levels
%   GIVEN       with one more effect, named after the first variable of the
%               levels: full strength is the next finer level, at the run of the
%               last level that is nearest to the measurement. The same where
%               the levels tell nothing of it, or where the user has a candidate
%               of that name
%   JUDGE       handle: LEVEL = JUDGE (DIAGNOSIS, OPTIONS), of diagnoseMatrices
%               (reached at the last level) and gapOptions
%   LEVEL       [] where the case has no levels; else variables (1 x v cell),
%               value and finer (1 x v: the last level, and one that is finer by
%               as much as the last is finer than the one before), shift and
%               shiftSd (1 x T: what going there is expected to do at the
%               calibrated set; NaN where the levels tell nothing), and verdict
%               and effects (of a diagnosis in which the model is moved by the
%               shift and the measurement is less sure by its deviation; ''
%               where the levels tell nothing of the finer one), holds (logical)
%
% How coarse the model is, is a gap of known cause. It acts on the results as an
% effect of the laboratory does, known as well as the surrogates know what the
% levels change: the runs of all levels say how it goes on, and no run is made.

function [given, judge] = finerLevel (given, surrogates, data, problem)
  judge = @(diagnosis, options) [];
  if ~isempty (problem.coarse)
    given = levelCandidate (given, surrogates, data, problem);
    judge = @(diagnosis, options) finerVerdict (surrogates, problem, given, ...
                                                options, diagnosis);
  end
end

function given = levelCandidate (given, surrogates, data, problem)
  name = problem.coarse.variables{1};
  isNamed = ~isempty (given.effects) && ...
            any (strcmp ({given.effects.name}, name));
  last = keepRows (data, all (data.E == problem.coarse.levels(end, :), 2));
  miss = (last.Z - given.value) ./ given.sd;
  [~, nearest] = min (mean (miss(:, problem.calibrate).^2, 2));
  if isNamed || isempty (nearest) || isempty (given.effects)
    return
  end
  step = finerStep (surrogates, problem, last.X(nearest, :));
  if any (isnan (step.shift))
    return
  end
  candidate = given.effects(end);
  candidate.name = name;
  candidate.label = sprintf ('%s = %.4g instead of %.4g, share of the way', ...
                             name, step.finer(1), step.value(1));
  [candidate.unit, candidate.group, candidate.siblings] = deal ('', '', {});
  [candidate.variables, candidate.neutral, candidate.limits] = deal ({}, [], zeros (2, 0));
  [candidate.laboratory, candidate.strongest, candidate.scale] = deal (true, 1, 2);
  candidate.range = [0, 1];
  % an effect whose full strength is the step to the next level, and nothing else
  candidate.offset = step.shift;
  candidate.offsetSd = step.shiftSd;
  candidate.matrix = zeros (numel (step.shift));
  given.effects(end + 1) = candidate;
end

% The diagnosis again, as one of the finer level.
function level = finerVerdict (surrogates, problem, given, options, diagnosis)
  level = [];
  % what a finer level does is done to both conditions of a change
  if ~isempty (diagnosis.problem.reference)
    return
  end
  level = finerStep (surrogates, problem, diagnosis.where.params);
  [level.verdict, level.effects, level.holds] = deal ('', {}, false);
  if any (isnan (level.shift))
    return
  end
  % moving the model up is moving the measurement down
  given.value = given.value - level.shift;
  given.sd = sqrt (given.sd.^2 + level.shiftSd.^2);
  if ~isempty (given.covariance)
    given.covariance = given.covariance + diag (level.shiftSd.^2);
  end
  % the verdict is wanted, not what else a diagnosis tells
  [options.maxNewRuns, options.bootstrap] = deal (0, 1);
  there = diagnoseMatrices (given, diagnosis.data, options, []);
  level.verdict = there.which.verdict;
  level.effects = there.which.effects;
  level.holds = strcmp (level.verdict, diagnosis.which.verdict) && ...
                isequal (level.effects, diagnosis.which.effects);
end

function step = finerStep (surrogates, problem, set)
  values = problem.coarse.levels;
  step = struct ('variables', {problem.coarse.variables}, ...
                 'value', values(end, :), 'finer', nextFiner (values));
  for t = numel (surrogates):-1:1
    level = unitLevel (problem.coarse, step.finer, t);
    [step.shift(t), step.shiftSd(t)] = levelShift (surrogates(t), set, level);
  end
end

% By the same ratio, of sizes; by the same step where a level is not above 0.
function finer = nextFiner (values)
  finer = 2 * values(end, :) - values(end - 1, :);
  isSize = all (values > 0, 1);
  ratio = values(end, isSize) ./ values(end - 1, isSize);
  finer(isSize) = values(end, isSize) .* ratio;
end

%!test
%! % the shift of the next finer level at the nearest run, once
%! pkg load stk
%! rand ('twister', 5);
%! X = rand (24, 1);
%! level = [2 * ones(12, 1); ones(12, 1)];
%! data = addRows (newData (1, 1), X, X + 0.2 * level, ones (24, 1), 'plan', ...
%!                 level);
%! problem = smallProblem (0.5, 0.01);
%! problem.coarse = struct ('variables', {{'size'}}, 'levels', [2; 1], ...
%!                          'column', 1);
%! surrogates = fitSurrogates (data, problem);
%! given = problem;
%! given.sd = 0.1;
%! given.effects = newEffect (struct ('name', 'gain', 'laboratory', true), 1);
%! given = finerLevel (given, surrogates, data, problem);
%! assert (given.effects(2).name, 'size');
%! assert (given.effects(2).offset, -0.1, 0.05);
%! again = finerLevel (given, surrogates, data, problem);
%! assert (numel (again.effects), 2);
%!test
%! % sizes go on by their ratio, other levels by their step; levels that tell
%! % nothing of a finer one, a change, no levels
%! problem.coarse = struct ('variables', {{'size'}}, 'levels', [4; 2], ...
%!                          'column', 1);
%! [data.X, data.E, data.Z] = deal (zeros (0, 1));
%! diagnosis.problem.reference = [];
%! diagnosis.where.params = 0.5;
%! problem.calibrate = true;
%! given = struct ('effects', [], 'value', 1, 'sd', 1);
%! level = @(problem, diagnosis) ...
%!   nthargout (2, @finerLevel, given, struct ('extra', []), data, ...
%!              problem) (diagnosis, []);
%! found = level (problem, diagnosis);
%! assert ({found.value, found.finer, found.shift}, {2, 1, NaN});
%! assert ({found.verdict, found.holds}, {'', false});
%! problem.coarse.levels = [1; 0];
%! assert (level (problem, diagnosis).finer, -1);
%! diagnosis.problem.reference = 1;
%! assert (isempty (level (problem, diagnosis)));
%! assert (isempty (level (struct ('coarse', []), diagnosis)));

% SPDX-License-Identifier: GPL-3.0-only
