% LOGLIKELIHOOD  Logarithm of the density of independent Student residuals.
%
% CALL: [L, CHI2, WEIGHT] = logLikelihood (R, V, NU [, COMMON])
%
%   R       n x T, residuals;  V  n x T, estimated variances
%   NU      1 x T, degrees of freedom of the estimates (Inf: known)
%   COMMON  struct: freedom of one unknown scale of the columns AT (1 x T logical; Inf:
%           none), stretch (1 x T, V over the squared scale of R)
%   L       n x 1, sum over the targets
%   CHI2    n x 1, sum of R^2 / V
%   WEIGHT  n x T, -dL/dR = WEIGHT .* R ./ V
%
% A residual over a standard deviation that was itself estimated is Student
% distributed: a noise known from few runs excludes less than its size says. What
% few trials tell of their scatter is wrong for all targets at once: a multivariate
% Student density, whose sum of squares is that of the former.

function [L, chi2, weight] = logLikelihood (R, V, nu, common)
  nu = min (nu, 1e4);
  stretch = 1;
  if nargin > 3
    stretch = common.stretch;
  end
  x = R.^2 ./ V;
  constant = gammaln ((nu + 1) / 2) - gammaln (nu / 2) - 0.5 * log (pi * nu);
  each = (nu + 1) .* log1p (stretch .* x ./ nu);
  [gain, share] = deal (0, 1);
  if nargin > 3 && isfinite (common.freedom)
    [each, gain, share] = withScale (each, common);
  end
  L = gain + sum (constant - 0.5 * log (V ./ stretch) - 0.5 * each, 2);
  if nargout > 1
    chi2 = sum (x, 2);
    weight = stretch .* share .* (nu + 1) ./ (nu + stretch .* x);
  end
end

function [each, gain, share] = withScale (each, common)
  n = sum (common.at);
  nu = common.freedom;
  rho = sum (each(:, common.at), 2);
  gain = gammaln ((nu + n) / 2) - gammaln (nu / 2) - n / 2 * log (nu / 2) - ...
         (nu + n) / 2 * log1p (rho / nu);
  share = ones (size (each));
  share(:, common.at) = repmat ((nu + n) ./ (nu + rho), 1, n);
  each(:, common.at) = 0;
end

%!test
%! [L, chi2, w] = logLikelihood ([1, 2], [1, 4], [Inf, Inf]);
%! assert (L, -1 - log (2 * pi) - log (2), 1e-3);
%! assert (chi2, 2);
%! assert (w, [1, 1], 1e-3);
%!assert (logLikelihood (1, 1, 1), -log (2 * pi), 1e-12)
%!test
%! % one scale of two columns: the bivariate Student density; of one: Student's
%! common = struct ('freedom', 3, 'stretch', [1, 1, 1], 'at', [true, true, false]);
%! [L, ~, w] = logLikelihood ([1, 2, 1], [1, 4, 1], Inf (1, 3), common);
%! exact = gammaln (2.5) - gammaln (1.5) - log (3 * pi) - log (2) - ...
%!         2.5 * log1p (2 / 3) - 0.5 - 0.5 * log (2 * pi);
%! assert (L, exact, 1e-3);
%! assert (w, [1, 1, 1], 1e-3);
%! common = struct ('freedom', 3, 'stretch', 4, 'at', true);
%! assert (logLikelihood (1, 1, Inf, common), ...
%!         logLikelihood (1, 0.25, 3), 1e-3);
%! [~, ~, w] = logLikelihood (1, 1, Inf, common);
%! slope = (logLikelihood (1 + 1e-5, 1, Inf, common) - ...
%!          logLikelihood (1 - 1e-5, 1, Inf, common)) / 2e-5;
%! assert (-slope, w, 1e-4);

% SPDX-License-Identifier: GPL-3.0-only
