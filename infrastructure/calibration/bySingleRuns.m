% BYSINGLERUNS  How the published search on the DEM evaluates a set.
%
% CALL: WAY = bySingleRuns (BOOK, PROBLEM)
%
% BOOK      containers.Map of calibrateOnDEM: its state grows by the runs
% PROBLEM   struct of newProblem
% WAY       struct, see calibrateOnDEM (searchOnDEM)
%
% One run is an evaluation, all rows of costFunction count as they are, and the
% Jacobian is that of finite differences, as published; but a
% set that was run is not run again. Where the budget is spent, or a run fails,
% there is no result: NaN, which the search takes for no improvement.
%
% See also: calibrateOnDEM, byAllRuns

function way = bySingleRuns (book, problem)
  extra = numel (problem.value) + (1:problem.nExtra);
  kept = [find(problem.calibrate), extra];
  respond = @(P) onceOnDEM (P, book, problem);
  way = struct ('kept', kept, 'weights', ones (numel (kept), 1), ...
                'respond', respond, ...
                'slopes', @(p, f) differencesOnDEM (p, f, respond, kept, ...
                                                    book('state'), problem), ...
                'isOver', @() whyOver (book, problem));
  way.told = struct ('tolRes', problem.tol(problem.calibrate), ...
                     'maxIter', problem.options.maxIter);
end

function Z = onceOnDEM (P, book, problem)
  state = book('state');
  Z = knownAt (state.data, P, problem);
  isNew = any (isnan (Z), 2);
  if any (isNew)
    state = runAndFit (state, problem, P(isNew, :), 'verify');
    book('state') = state;
    Z = knownAt (state.data, P, problem);
  end
end

% The mean of the finished runs at each set.
function Z = knownAt (data, P, problem)
  isWhole = all (isfinite (data.Z), 2);
  Z = NaN (rows (P), columns (data.Z));
  for i = 1:rows (P)
    own = isWhole & sameSet (data.X, P(i, :), problem.limits);
    if any (own)
      Z(i, :) = mean (data.Z(own, :), 1);
    end
  end
end

% An iteration needs the runs of a Jacobian and one more; a start without a
% result leads nowhere.
function why = whyOver (book, problem)
  state = book('state');
  why = '';
  if budgetLeft (state, problem) < numel (problem.names) + 1
    why = 'too few DEM runs are left for an iteration';
  elseif book('iteration') == 1
    p = state.found.params;
    if any (isnan (knownAt (state.data, p, problem)))
      why = 'the run at the set found on the Kriging models failed';
    end
  end
end

% Jacobian by runs, in the unit box. Forward differences as published, but for
% the step: it moves the responses by 4 times the scatter of one run, as a
% smaller one would measure that scatter (between 2 and 20 % of the box); the d
% runs go out as one batch. Where a run fails, it is that of the surrogates.
function J = differencesOnDEM (p, f, respond, kept, state, problem)
  lo = problem.limits(1, :);
  width = diff (problem.limits);
  u = (p - lo) ./ width;
  step = stepsOf (state.surrogates, problem, p);
  step(u + step > 1) = -step(u + step > 1);
  P = lo + (u + full (diag (step))) .* width;
  Z = respond (P);
  onKriging = @(q) evaluateKriging (q, state.surrogates);
  J = zeros (numel (f), numel (p));
  for j = 1:numel (p)
    base = f;
    z = Z(j, :)';
    if any (isnan (z))
      z = onKriging (P(j, :));
      base = rowsAt (problem, p, onKriging (p), kept);
    end
    J(:, j) = (rowsAt (problem, P(j, :), z, kept) - base) / step(j);
  end
end

function r = rowsAt (problem, p, z, kept)
  r = problem.cost (p(:), @(varargin) z(:))(kept)(:);
end

function step = stepsOf (surrogates, problem, p)
  use = problem.calibrate;
  [~, slope] = targetResidual (problem, p, predictSurrogate (surrogates, p));
  noise = sqrt ([surrogates(use).noiseVar]) .* abs (slope(use)) ./ ...
          problem.part(use);
  steep = max (abs (surrogateJacobian (surrogates, problem, p)), 1e-6);
  step = min (max (4 * min (noise' ./ steep, [], 1), 0.02), 0.2);
end

%!test
%! % what was run is not run again, nor counted; no budget, no result
%! [problem, state] = smallCalibration ();
%! problem.options.maxFunEvals = 2;
%! state.evaluate = plainEvaluate (@(P, E, r) P);
%! book = containers.Map ({'state', 'iteration'}, {state, 0});
%! way = bySingleRuns (book, problem);
%! assert (way.respond (state.data.X(3:4, :)), state.data.Z(3:4, :));
%! assert (! any (isAfterPlan (book('state').data)));
%! assert (way.respond ([0.1, 0.2; state.data.X(1, :); 0.3, 0.4; 0.5, 0.6]), ...
%!         [0.1, 0.2; state.data.Z(1, :); 0.3, 0.4; NaN, NaN]);
%! assert (sum (isAfterPlan (book('state').data)), 2);
%! assert (! isempty (way.isOver ()));

%!test
%! % rows beyond the targets are differentiated too; a failed run is not
%! [problem, state] = smallCalibration ();
%! problem.cost = @(p, f) [f(p) ./ [4; 2] - 1; p(2)];
%! problem.nExtra = 1;
%! law = @(P) [3 + P(:, 1) + P(:, 2) / 2, 1 + P(:, 1) + P(:, 2) / 2.5];
%! f = problem.cost ([0.5; 1], @(p) law (p')');
%! slopes = @(state) bySingleRuns (containers.Map ({'state', 'iteration'}, ...
%!                      {state, 0}), problem).slopes ([0.5, 1], f);
%! state.evaluate = plainEvaluate (@(P, E, r) law (P));
%! J = slopes (state);
%! assert (J, [0.25, 0.25; 0.5, 0.4; 0, 2], 1e-9);
%! state.evaluate = plainEvaluate (@(P, E, r) law (P) + 0 ./ (P(:, 1) == 0.5));
%! J = slopes (state);
%! assert (J(:, 2), [0.25; 0.4; 2], 1e-9);
%! assert (J(:, 1), [0.25; 0.5; 0], 0.05);
