% HOPEFULSETS  Sets at which the targets may be met, the found one first.
%
% CALL: Q = hopefulSets (STATE, PROBLEM)
%
%   STATE    struct of newState; surrogates and found are read
%   PROBLEM  struct of newProblem
%   Q        m x d, allowed sets of the box
%
% The 200 of many random sets that would meet the targets best if the surrogates
% err in their favour by two deviations; of these and the found one, 20 that lie far
% apart are brought to where the mean responses are on target. Random sets are
% no use themselves: a tolerance of 1 % of three targets leaves a millionth of the
% box. With them stand two sets on the straight way there from the found one, as
% the surrogates are surer of the way than of its end.

function Q = hopefulSets (state, problem)
  found = state.found.params;
  U = toUnit (candidateSets (state.surrogates, problem, found), problem.limits);
  a = toUnit (found, problem.limits);
  B = onTarget (state.surrogates, problem, [a; U(farPoints (U, a, 20), :)]);
  B = [B; a + (B - a) / 3; a + (B - a) * 2 / 3];
  Q = [found; toAllowed(fromUnit (B, problem.limits), problem)];
  Q = unique (Q, 'rows', 'stable');
end

function C = candidateSets (surrogates, problem, found)
  d = columns (problem.limits);
  sample = toAllowed (sampleBox (1000, problem.limits), problem);
  near = double (stk_sampling_halton_rr2 (100, d, [-ones(1, d); ones(1, d)]));
  P = [sample; setsAround(found, 0.15 * near, problem)];
  [r, s] = residualSpread (surrogates, problem, P);
  [share, spread] = toleranceShare (problem, r, s);
  optimist = max (share - 2 * spread, 0);
  [~, order] = sort (sum (optimist.^2, 2));
  C = P(order(1:200), :);
end

% Newton's steps of least length, at most 0.3 of the box, for all sets U (k x d, in
% the unit box) at once; a parameter at a wall that a step would leave stays there.
% Two parameters, two targets: 0.02 s for all; leastSquaresInBox takes 0.05 s for one,
% and a round would take seconds.
function U = onTarget (surrogates, problem, U)
  for iteration = 1:5
    [f, J] = linearAt (surrogates, problem, U);
    for i = find (max (abs (f), [], 2) > 0.1)'
      step = stepInBox (reshape (J(i, :, :), [], columns (U)), f(i, :)', U(i, :));
      U(i, :) = min (max (U(i, :) + step, 0), 1);
    end
  end
end

% Residuals in tolerances (k x t) of the mean at U and their slopes (k x t x d) by
% forward differences away from the wall.
function [f, J] = linearAt (surrogates, problem, U)
  [k, d] = size (U);
  h = 1e-3 * (1 - 2 * (U > 0.5));
  V = repmat (U, d + 1, 1);
  for j = 1:d
    own = j * k + (1:k);
    V(own, j) = V(own, j) + h(:, j);
  end
  use = problem.calibrate;
  r = residualSpread (surrogates, problem, fromUnit (V, problem.limits));
  r = r(:, use) ./ problem.part(use);
  f = r(1:k, :);
  J = zeros ([size(f), d]);
  for j = 1:d
    J(:, :, j) = (r(j * k + (1:k), :) - f) ./ h(:, j);
  end
end

function step = stepInBox (J, f, u)
  step = zeros (size (u));
  isFree = true (size (u));
  while any (isFree)
    step(:) = 0;
    step(isFree) = -pinv (J(:, isFree), 1e-3 * norm (J)) * f;
    isOut = isFree & ((u <= 0 & step < 0) | (u >= 1 & step > 0));
    if ~any (isOut)
      break
    end
    isFree(isOut) = false;
    step(isOut) = 0;
  end
  longest = max (abs (step));
  if longest > 0.3
    step = step * 0.3 / longest;
  end
end

%!test
%! % the found set first; the others in the box, and those that were brought to the
%! % targets (x at 4, y at 2: one set) are there
%! [problem, state, surrogates] = smallCalibration ();
%! Q = hopefulSets (state, problem);
%! assert (Q(1, :), state.found.params);
%! assert (all (Q(:) >= 0 & Q(:) <= kron ([1; 2], ones (rows (Q), 1))));
%! r = residualSpread (surrogates, problem, Q);
%! assert (sum (max (abs (r), [], 2) < 0.002) >= 3);
%!test
%! % more parameters than targets: they lie far apart along the line of solutions
%! rand ('twister', 1);
%! randn ('twister', 1);
%! C = struct ('names', {{'a', 'b'}}, 'limits', [0, 0; 1, 1], ...
%!             'targets', struct ('value', 2, 'tol', 0.01));
%! problem = newProblem (C, []);
%! X = rand (12, 2);
%! data = addRows (newData (2, 1), X, 1 + sum (X, 2), ones (12, 1), 'plan');
%! s = fitSurrogates (data, problem);
%! Q = hopefulSets (newState (data, s, describeSet (s, problem, [0.5, 0.5])), problem);
%! isOn = abs (sum (Q, 2) - 1) < 0.002;
%! assert (sum (isOn) > 10);
%! assert (range (Q(isOn, 1)) > 0.7);
%!test
%! % a parameter at its wall stays there, the other one goes on
%! C = struct ('names', {{'a', 'b'}}, 'limits', [0, 0; 1, 1], ...
%!             'targets', struct ('value', 2.9, 'tol', 0.01));
%! rand ('twister', 1);
%! problem = newProblem (C, []);
%! X = rand (12, 2);
%! data = addRows (newData (2, 1), X, 1 + sum (X, 2), ones (12, 1), 'plan');
%! s = fitSurrogates (data, problem);
%! Q = hopefulSets (newState (data, s, describeSet (s, problem, [1, 0.1])), problem);
%! assert (min (abs (sum (Q, 2) - 1.9)) < 0.005);

% SPDX-License-Identifier: GPL-3.0-only
