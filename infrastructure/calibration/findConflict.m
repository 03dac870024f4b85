% FINDCONFLICT  Targets that no set of the box meets together.
%
% CALL: NAMES = findConflict (SURROGATES, PROBLEM)
% CALL: [NAMES, EXCESS] = findConflict (SURROGATES, PROBLEM)
%
% NAMES   cellstr: {} if all targets can be met within options.apart standard
%         deviations of the surrogates; else the smallest group found that
%         conflicts (one name: that target lies outside what the box reaches)
% EXCESS  scalar: how far the best compromise stays outside the tolerances, in
%         standard deviations of the surrogates there (0: met)
%
% Starting from all targets, each one is left out in turn; it is named when
% the rest can be met without it no better. A curve is one target.

function [names, excess] = findConflict (surrogates, problem)
  [group, known] = requirementsOf (problem);
  excess = leastExcess (surrogates, problem, [group{:}]);
  if excess <= problem.options.apart
    names = {};
    return
  end
  left = true (1, numel (group));
  for k = 1:numel (group)
    left(k) = false;
    left(k) = ~any (left) || ...
              leastExcess (surrogates, problem, [group{left}]) <= ...
              problem.options.apart;
  end
  names = known(left);
end

function excess = leastExcess (surrogates, problem, group)
  % largest (|residual| - tolerance) / sd of the group, least over the box
  limits = problem.limits;
  d = columns (limits);
  P = [mean(limits, 1); insideLimits(surrogates(1).X, limits); ...
       double(stk_sampling_halton_rr2 (1000, d, limits))];
  problem.calibrate(:) = false;
  problem.calibrate(group) = true;
  loss = @(P) worstExcess (surrogates, problem, P);
  [~, i] = min (loss (P));
  radii = [0.3, 0.2, 0.1, 0.05, 0.03, 0.02];
  excess = loss (shrinkingSearch (loss, P(i, :), radii, 100, limits));
end

function worst = worstExcess (surrogates, problem, P)
  [r, s] = residualSpread (surrogates, problem, P);
  [share, spread] = toleranceShare (problem, r, s);
  worst = max ((share - 1) ./ max (spread, 1e-3), [], 2);
  worst = max (worst, 0);
end

%!shared problem, state, s, data
%! pkg load stk
%! pkg load -nodeps struct optim
%! rand ('twister', 2);
%! randn ('twister', 2);
%! C = struct ('names', {{'a', 'b'}}, 'limits', [0, 0; 1, 2]);
%! C.targets = struct ('name', {'x', 'y'}, 'value', {4, 2}, 'tol', 0.02);
%! problem = newProblem (C, []);
%! X = rand (12, 2) .* [1, 2];
%! Z = [3 + X(:, 1) + X(:, 2) / 2, 1 + X(:, 1) + X(:, 2) / 2.5];
%! data = addRows (newData (2, 2), X, Z .* (1 + 0.003 * randn (12, 2)), ...
%!                 ones (12, 1), 'plan');
%! s = fitSurrogates (data, problem);
%! state = newState (data, s, describeSet (s, problem, [0.5, 1]));
%! state.found.conflict = {};

%!test
%! [names, excess] = findConflict (s, problem);
%! assert (isempty (names));
%! assert (excess, 0, 1);

%!test
%! % x = 3.2 wants little, y = 2.7 wants much: each can be met, not both
%! problem.value = [3.2, 2.7];
%! [names, excess] = findConflict (s, problem);
%! assert (names, {'x', 'y'});
%! assert (excess > 3);

%!test
%! % runs outside the box, taken in from another case, reach nothing in it
%! far = addRows (data, [3, 2; 4, 2], [7, 4.8; 8, 5.8], ones (2, 1), 'import');
%! outside = problem;
%! outside.value(1) = 7;
%! outside.calibrate(2) = false;
%! assert (findConflict (fitSurrogates (far, outside), outside), {'x'});
