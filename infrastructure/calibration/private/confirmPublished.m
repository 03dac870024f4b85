% CONFIRMPUBLISHED  How the published search on the DEM evaluates a set.
%
% CALL: WAY = confirmPublished (PROBLEM)
%
% WAY       struct, see calibrateOnDEM (searchOnDEM)
%
% One run is an evaluation, all rows of costFunction count as they are, and the
% Jacobian is that of finite differences, as published; but a set that was run
% is not run again. Where the budget is spent, or a run fails, there is no
% result: NaN, which the search takes for no improvement.

function way = confirmPublished (problem)
  extra = numel (problem.value) + (1:problem.nExtra);
  kept = [find(problem.calibrate), extra];
  way = struct ('kept', kept, 'weights', ones (numel (kept), 1), ...
                'respond', @(P, book) onceOnDEM (P, book, problem), ...
                'slopes', @(p, f, book) differencesOnDEM (p, f, kept, book, ...
                                                          problem), ...
                'isOver', @(book) whyOver (book, problem), ...
                'judge', @(p, why, book) publishedEnd (p, why, book, problem));
  way.settings = struct ('tolRes', problem.tol(problem.calibrate), ...
                         'maxIter', problem.options.maxIter);
end

function [Z, book] = onceOnDEM (P, book, problem)
  Z = knownAt (book.state.data, P, problem);
  isNew = any (isnan (Z), 2);
  if any (isNew)
    book.state = runAndFit (book.state, problem, P(isNew, :), 'verify');
    Z = knownAt (book.state.data, P, problem);
  end
end

% The mean of the finished runs at each set.
function Z = knownAt (data, P, problem)
  isWhole = all (isfinite (data.Z), 2);
  Z = NaN (rows (P), columns (data.Z));
  for i = 1:rows (P)
    isThere = isWhole & sameSet (data.X, P(i, :), problem.limits);
    if any (isThere)
      Z(i, :) = mean (data.Z(isThere, :), 1);
    end
  end
end

% An iteration needs the runs of a Jacobian and one more; a start without a
% result leads nowhere.
function why = whyOver (book, problem)
  state = book.state;
  why = '';
  if budgetLeft (state, problem) < numel (problem.names) + 1
    why = 'too few DEM runs are left for an iteration';
  elseif book.iteration == 1 && ...
         any (isnan (knownAt (state.data, state.found.params, problem)))
    why = 'the run at the set found on the Kriging models failed';
  end
end

% Forward differences in the unit box as published, but the step moves the
% responses by 4 times the scatter of one run, as a smaller one would measure
% that scatter (between 2 and 20 % of the box); the d runs go out as one batch.
% Where a run fails, it is the difference of the surrogates.
function [J, book] = differencesOnDEM (p, f, kept, book, problem)
  surrogates = book.state.surrogates;
  u = toUnit (p, problem.limits);
  m = predictSurrogate (surrogates, p);
  step = stepsOf (m, surrogates, problem, p);
  step(u + step > 1) = -step(u + step > 1);
  P = fromUnit (u + full (diag (step)), problem.limits);
  [Z, book] = onceOnDEM (P, book, problem);
  J = zeros (numel (f), numel (p));
  for j = 1:numel (p)
    base = f;
    z = Z(j, :)';
    if any (isnan (z))
      z = predictSurrogate (surrogates, P(j, :));
      base = rowsAt (problem, p, m, kept);
    end
    J(:, j) = (rowsAt (problem, P(j, :), z, kept) - base) / step(j);
  end
end

function r = rowsAt (problem, p, z, kept)
  r = problem.cost (p(:), @(varargin) z(:))(kept)(:);
end

function step = stepsOf (m, surrogates, problem, p)
  use = problem.calibrate;
  [~, slope] = targetResidual (problem, p, m);
  noise = sqrt ([surrogates(use).noiseVar]) .* abs (slope(use)) ./ ...
          problem.part(use);
  steep = max (abs (surrogateJacobian (surrogates, problem, p)), 1e-6);
  step = min (max (4 * min (noise' ./ steep, [], 1), 0.02), 0.2);
end

% The set of nonlin_residmin; where its last trial has no result, the best that
% has one. What the published program calls met, is met; what a robust
% calibration would make of it, is said.
function [book, isEnd] = publishedEnd (p, why, book, problem)
  state = book.state;
  isEnd = true;
  isFinished = all (isfinite (state.data.Z), 2);
  run = keepRows (state.data, ...
                  strcmp (state.data.stage, 'verify') & isFinished);
  if ~isempty (run.X) && any (isnan (knownAt (run, p, problem)))
    r = targetResidual (problem, run.X, run.Z)(:, problem.calibrate);
    [~, best] = min (sumsq (r, 2));
    p = run.X(best, :);
  end
  state.found = mergeFields (state.found, ...
                             describeSet (state.surrogates, problem, p));
  final = confirmSet (state, problem);
  code = 'unsure';
  if final.converged
    code = 'converged';
  elseif final.probability < problem.options.wrong
    code = 'wrong';
  end
  chances = round (100 * [final.probability, problem.options.confidence]);
  rest = sentence (['rest.', code], struct ('probability', chances(1), ...
                                            'wanted', chances(2)));
  final.met = final.n > 0 & abs (final.residual') <= problem.tol;
  final.state(final.met) = {'met'};
  final.state(~final.met) = {'missed'};
  final.converged = all (final.met(problem.calibrate));
  final.untested = zeros (0, numel (p));
  if final.converged
    final.limit = '';
  end
  final.ending = newEnding ('published', ...
                            struct ('stopped', why, 'rest', rest));
  final.reason = final.ending.text;
  state.final = final;
  book.state = state;
end

%!function [problem, book, law] = started ()
%!  [problem, state, ~, law] = smallCalibration ();
%!  book = struct ('state', state, 'iteration', 0);
%!endfunction
%!test
%! % what was run is not run again, nor counted; no budget, no result
%! [problem, book] = started ();
%! problem.options.maxFunEvals = 2;
%! book.state.evaluate = newEvaluate (@(P, E, r) P);
%! X = book.state.data.X;
%! Z = book.state.data.Z;
%! way = confirmPublished (problem);
%! [found, book] = way.respond (X(3:4, :), book);
%! assert (found, Z(3:4, :));
%! assert (! any (isAfterPlan (book.state.data)));
%! [found, book] = way.respond ([0.1, 0.2; X(1, :); 0.3, 0.4; 0.5, 0.6], book);
%! assert (found, [0.1, 0.2; Z(1, :); 0.3, 0.4; NaN, NaN]);
%! assert (sum (isAfterPlan (book.state.data)), 2);
%! assert (! isempty (way.isOver (book)));
%!test
%! % rows beyond the targets are differentiated too; a failed run is not
%! [problem, book, law] = started ();
%! problem.cost = @(p, f) [f(p) ./ [4; 2] - 1; p(2)];
%! problem.nExtra = 1;
%! f = problem.cost ([0.5; 1], @(p) law (p')');
%! slopes = confirmPublished (problem).slopes;
%! J = slopes ([0.5, 1], f, book);
%! assert (J, [0.25, 0.25; 0.5, 0.4; 0, 2], 1e-9);
%! fails = @(P) 0 ./ (P(:, 1) == 0.5);
%! book.state.evaluate = newEvaluate (@(P, E, r) law (P) + fails (P));
%! J = slopes ([0.5, 1], f, book);
%! assert (J(:, 2), [0.25; 0.4; 2], 1e-9);
%! assert (J(:, 1), [0.25; 0.5; 0], 0.05);

% SPDX-License-Identifier: GPL-3.0-only
