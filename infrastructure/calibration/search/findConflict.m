% FINDCONFLICT  Targets that no set of the box meets together.
%
% CALL: NAMES = findConflict (SURROGATES, PROBLEM)
%
% NAMES   cellstr: {} if all targets can be met within options.apart standard
%         deviations of the surrogates; else the smallest group found that
%         conflicts (one name: that target lies outside what the box reaches)
%
% Starting from all targets, each one is left out in turn; it is named when
% the rest can be met without it no better. A curve is one target. Nothing is
% named where a run that was left out lies at or beyond the targets, seen from
% the best set: what it shows may be the way.

function names = findConflict (surrogates, problem)
  [group, known] = requirementsOf (problem);
  left = true (1, numel (group));
  if areMet (surrogates, problem, [group{:}])
    names = {};
    return
  end
  for k = 1:numel (group)
    left(k) = false;
    left(k) = ~any (left) || areMet (surrogates, problem, [group{left}]);
  end
  names = known(left);
  if isReached (surrogates, problem, [group{left}])
    names = {};
  end
end

% A run that was left out is within the tolerance of each target of the group or
% on its other side.
function yes = isReached (surrogates, problem, group)
  aside = [surrogates.aside];
  yes = false;
  if isempty (aside)
    return
  end
  r = residualSpread (surrogates, problem, surrogates(1).X);
  side = sign (r(closest (r(:, group) ./ problem.tol(group)), group));
  z = targetResidual (problem, repmat (mean (problem.limits(1:2, :), 1), ...
                                       rows (aside), 1), aside);
  yes = any (all (z(:, group) .* -side >= -problem.tol(group), 2));
end

function i = closest (share)
  [~, i] = min (max (abs (share), [], 2));
end

function yes = areMet (surrogates, problem, group)
  limits = problem.limits;
  P = toAllowed ([problem.centre; ...
                  insideLimits(surrogates(1).X, limits); ...
                  sampleBox(1000, limits)], problem);
  problem.calibrate(:) = false;
  problem.calibrate(group) = true;
  loss = @(P) worstExcess (surrogates, problem, P);
  [~, i] = min (loss (P));
  radii = [0.3, 0.2, 0.1, 0.05, 0.03, 0.02];
  yes = loss (shrinkingSearch (loss, P(i, :), radii, 100, problem)) <= ...
        problem.options.apart;
end

% Largest (|residual| - tolerance) / sd of the calibrated targets.
% A published residual needs the response of its own target alone.
function worst = worstExcess (surrogates, problem, P)
  if problem.standard
    use = problem.calibrate;
    [r, s] = deal (NaN (rows (P), numel (use)));
    [m, v] = predictSurrogate (surrogates(use), P);
    r(:, use) = (m - problem.value(use)) ./ problem.scale(use);
    s(:, use) = sqrt (v) ./ abs (problem.scale(use));
  else
    [r, s] = residualSpread (surrogates, problem, P);
  end
  [share, spread] = toleranceShare (problem, r, s);
  worst = max (max ((share - 1) ./ max (spread, 1e-3), [], 2), 0);
end

%!shared problem, state, s
%! [problem, state, s] = smallCalibration ();

%!test
%! % x = 3.2 wants little, y = 2.7 wants much: each can be met, not both
%! assert (isempty (findConflict (s, problem)));
%! apart = setfield (problem, 'value', [3.2, 2.7]);
%! assert (findConflict (s, apart), {'x', 'y'});

%!test
%! % runs outside the box, taken in from another case, reach nothing in it
%! far = addRows (state.data, [3, 2; 4, 2], [7, 4.8; 8, 5.8], ones (2, 1), ...
%!                'import');
%! problem.value = [7, 2.7];
%! problem.calibrate(2) = false;
%! assert (findConflict (fitSurrogates (far, problem), problem), {'x'});
%!test
%! % nothing is named while a run that was left out lies at the target or beyond
%! [problem, ~, s] = smallCalibration ();
%! problem.value(1) = 9;
%! assert (findConflict (s, problem), {'x'});
%! [s.aside] = deal ([4; 8.95], [2; 2]);
%! assert (isempty (findConflict (s, problem)));
%! s(1).aside(2) = 12;
%! assert (isempty (findConflict (s, problem)));
%! s(1).aside(2) = 7;
%! assert (findConflict (s, problem), {'x'});

% SPDX-License-Identifier: GPL-3.0-only
