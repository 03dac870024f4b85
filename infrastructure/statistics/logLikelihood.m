% LOGLIKELIHOOD  Logarithm of the density of independent Student residuals.
%
% CALL: [L, CHI2, WEIGHT] = logLikelihood (R, V, NU)
%
%   R       n x T, residuals;  V  n x T, estimated variances
%   NU      1 x T, degrees of freedom of the estimates (Inf: known)
%   L       n x 1, sum over the targets
%   CHI2    n x 1, sum of R^2 / V
%   WEIGHT  n x T, -dL/dR = WEIGHT .* R ./ V
%
% A residual over a standard deviation that was itself estimated is Student
% distributed: a noise known from few runs excludes less than its size says.

function [L, chi2, weight] = logLikelihood (R, V, nu)
  nu = min (nu, 1e4);
  x = R.^2 ./ V;
  constant = gammaln ((nu + 1) / 2) - gammaln (nu / 2) - 0.5 * log (pi * nu);
  L = sum (constant - 0.5 * log (V) - (nu + 1) / 2 .* log1p (x ./ nu), 2);
  if nargout > 1
    chi2 = sum (x, 2);
    weight = (nu + 1) ./ (nu + x);
  end
end

%!test
%! [L, chi2, w] = logLikelihood ([1, 2], [1, 4], [Inf, Inf]);
%! assert (L, -1 - log (2 * pi) - log (2), 1e-3);
%! assert (chi2, 2);
%! assert (w, [1, 1], 1e-3);
%!assert (logLikelihood (1, 1, 1), -log (2 * pi), 1e-12)
