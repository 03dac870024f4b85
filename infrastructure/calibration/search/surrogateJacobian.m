% SURROGATEJACOBIAN  Jacobian of the scaled residuals on the surrogates.
%
% CALL: [J, F] = surrogateJacobian (SURROGATES, PROBLEM, P [, ISWIDE])
%
% P  1 x d  parameter set;  ISWIDE  logical, with the deviations (false)
% F  t x 1  residual / tolerance (PROBLEM.part, in which a curve counts as one
%           target) of the t calibrated targets; ISWIDE: after them the standard
%           deviations of the residuals, 2 t in all
% J  t x d  their derivative by the parameters in the unit box
%
% Central differences of 0.1 % of the box, all 2 d points in one call; at a
% limit the step is one-sided.

function [J, f] = surrogateJacobian (surrogates, problem, p, isWide)
  d = numel (p);
  u = toUnit (p, problem.limits);
  h = 1e-3;
  up = min (u + h * full (eye (d)), 1);
  dn = max (u - h * full (eye (d)), 0);
  P = [p; fromUnit([up; dn], problem.limits)];
  use = problem.calibrate;
  if nargin > 3 && isWide
    [r, s] = residualSpread (surrogates, problem, P);
    F = [r(:, use), s(:, use)] ./ [problem.part(use), problem.part(use)];
  else
    r = residualSpread (surrogates, problem, P);
    F = r(:, use) ./ problem.part(use);
  end
  J = ((F(2:d + 1, :) - F(d + 2:end, :)) ./ diag (up - dn))';
  f = F(1, :)';
end

%!test
%! rand ('twister', 1);
%! X = rand (15, 2) .* [1, 10];
%! limits = [0, 0; 1, 10];
%! s = fitSurrogate (X, 1 + X * [2; 0.3], limits);
%! problem = smallProblem (2, 0.5, 2, struct ('limits', limits));
%! [J, f] = surrogateJacobian (s, problem, [0.5, 10]);
%! assert (J, [2, 3], 0.02);
%! assert (f, (1 + 1 + 3 - 2) / 2 / 0.5, 0.02);
%! [J, f] = surrogateJacobian (s, problem, [0.5, 10], true);
%! assert (J(1, :), [2, 3], 0.02);
%! [~, sd] = residualSpread (s, problem, [0.5, 10]);
%! assert (f(2), sd / 0.5, 1e-9);

% SPDX-License-Identifier: GPL-3.0-only
