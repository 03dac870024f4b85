% SURROGATEJACOBIAN  Jacobian of the scaled residuals on the surrogates.
%
% CALL: [J, G] = surrogateJacobian (SURROGATES, PROBLEM, P)
%
% P  1 x d  parameter set
% J  t x d  derivative of residual / tolerance (PROBLEM.part, in which a curve
%           counts as one target) of the t calibrated targets by
%           the parameters in the unit box
% G  t x d  the same of the standard deviation of the residual
%
% Central differences of 0.1 % of the box, all 2 d points in one call; at a
% limit the step is one-sided.

function [J, G] = surrogateJacobian (surrogates, problem, p)
  d = numel (p);
  u = toUnit (p, problem.limits);
  h = 1e-3;
  up = min (u + h * full (eye (d)), 1);
  dn = max (u - h * full (eye (d)), 0);
  step = diag (up - dn);
  P = fromUnit ([up; dn], problem.limits);
  use = problem.calibrate;
  scaled = @(r) r(:, use) ./ problem.part(use);
  slopes = @(f) ((f(1:d, :) - f(d + 1:end, :)) ./ step)';
  n = max (nargout, 1);
  [known{1:n}] = residualSpread (surrogates, problem, P);
  J = slopes (scaled (known{1}));
  if n > 1
    G = slopes (scaled (known{2}));
  end
end

%!test
%! rand ('twister', 1);
%! X = rand (15, 2) .* [1, 10];
%! limits = [0, 0; 1, 10];
%! s = fitSurrogate (X, 1 + X * [2; 0.3], limits);
%! problem = smallProblem (2, 0.5, 2, struct ('limits', limits));
%! J = surrogateJacobian (s, problem, [0.5, 10]);
%! assert (J, [2, 3], 0.02);
