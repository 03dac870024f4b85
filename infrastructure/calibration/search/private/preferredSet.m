% PREFERREDSET  Moves a set to where it is preferred, along what the data leave open.
%
% CALL: [P, USED] = preferredSet (SURROGATES, PROBLEM, P0)
%
%   P0    1 x d, the surest set
%   P     1 x d: of the sets whose residuals are those of P0, the one with the least
%         sum of squares of the rows of the cost function below the targets (the
%         Rayleigh term) and of the distances to parameters that were measured by
%         themselves, in their standard deviations
%   USED  struct: before, after (that sum), share (largest change of a residual in
%         tolerances), spread (in standard errors of the residual)
%
% What was measured is not spent: a residual moves by a tenth of its tolerance at
% most, and by half of its standard error, and goes where it is known as well (1.4
% times the standard error, or a tenth of the tolerance). Where parameters are as many as targets
% the set stays; with more of them there are flat directions. Sets of a shrinking
% search are brought back along the steepest ways (chord steps of Newton's method,
% with the Jacobian in the middle), and those that come back within this are looked at.

function [p, used] = preferredSet (surrogates, problem, p0)
  use = problem.calibrate;
  unit = @(r) r(:, use) ./ problem.part(use);
  [r0, s0] = residualSpread (surrogates, problem, p0);
  most = min (0.1, 0.5 * unit (s0));
  off = @(P) unit (residualSpread (surrogates, problem, P)) - unit (r0);
  d = columns (p0);
  step = double (stk_sampling_halton_rr2 (200, d, [-ones(1, d); ones(1, d)]));
  sure = meetProbability (surrogates, problem, p0);
  least = max (problem.options.even, sure - problem.options.better);
  p = p0;
  value = preferenceOf (problem, p0);
  used = struct ('before', value, 'after', value, 'share', 0, 'spread', 0);
  for radius = [0.5, 0.3, 0.2, 0.1, 0.1, 0.05, 0.05, 0.02, 0.02, 0.01]
    J = surrogateJacobian (surrogates, problem, p);
    P = setsAround (p, radius * step, problem);
    wanted = broughtBack (P, off, J, problem);
    P = toDigits ([wanted; P]);
    [r, s] = residualSpread (surrogates, problem, P);
    isOpen = all (abs (unit (r) - unit (r0)) <= most + 1e-9, 2) & ...
             all (unit (s) <= max (1.4 * unit (s0), 0.1), 2);
    P = P(isOpen, :);
    P = P(meetProbability (surrogates, problem, P) >= least, :);
    [best, k] = min ([preferenceOf(problem, P); Inf]);
    if best < value
      value = best;
      p = P(k, :);
    end
  end
  used.after = value;
  used.share = max (abs (off (p)));
  used.spread = max (abs (off (p)) ./ max (unit (s0), realmin));
end

function P = broughtBack (P, off, J, problem)
  back = pinv (J, 1e-3 * norm (J))';
  for k = 1:6
    P = setsAround (P, -off (P) * back, problem);
  end
end

function value = preferenceOf (problem, P)
  z = (P - problem.paramMean) ./ problem.paramSd;
  value = sumsq (z(:, isfinite (problem.paramSd)), 2);
  T = numel (problem.value);
  for i = 1:rows (P) * (problem.nExtra > 0)
    r = problem.cost (P(i, :)', @(varargin) problem.value(:));
    value(i) = value(i) + sum (r(T + 1:end).^2);
  end
end

%!test
%! % as many parameters as targets: it stays; the data are exact
%! problem = smallProblem ([1, 0.2], 0.03, 2);
%! rand ('twister', 1);
%! X = rand (14, 2);
%! f = @(P) [P(:, 1) + P(:, 2), P(:, 1) .* P(:, 2)];
%! s = fitSurrogates (addRows (newData (2, 2), X, f (X), ones (14, 1), 'plan'), problem);
%! problem.cost = @(p, f) [f(p) ./ [1; 0.2] - 1; 1 - p(1)];
%! problem.nExtra = 1;
%! p0 = [0.2764, 0.7236];
%! [p, used] = preferredSet (s, problem, p0);
%! assert (p, p0, 2e-3);
%! assert (used.share <= 0.1 && used.spread <= 0.5);
%! % one target: along the line of the same sum as far as the limits let it
%! problem.calibrate(2) = false;
%! [p, used] = preferredSet (s, problem, p0);
%! assert (p, [1, 0], 0.03);
%! assert (sum (p), 1, 0.003);
%! assert (used.after < 0.05 * used.before);

% SPDX-License-Identifier: GPL-3.0-only
