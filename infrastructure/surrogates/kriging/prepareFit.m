% PREPAREFIT  The likelihood of a Kriging model, by its parameters.
%
% CALL: FIT = prepareFit (U, Y, TREND, KERNEL, NOISE [, OF])
%
% U       n x d  inputs in the unit box; Y  n x 1 standardised response
% TREND   'constant', 'affine' or 'quadratic'; KERNEL  see correlationOf
% NOISE   n x 1 known variances, or [] (estimated)
% OF      struct extra (n x 1, an input of U in which the logarithm of the
%         estimated noise is affine; []: in none), prior ((d + 2) x 1,
%         parameters as theta of a similar bench,
%         known to a factor of 1.6; NaN: not known; []: none), scatter and scale
%         (see noisePrior)
% FIT     struct, what does not depend on the parameters: S n^2 x d (squared
%         differences), W n x (n - q) (basis orthogonal to the trend), y,
%         kernel, noise, extra; prior mean and sd (as theta: the part beyond the
%         trend, ranges and noise of a usual DEM response); and
%   cost  handle [C, G] = FIT.cost (THETA), negative log density and gradient;
%         THETA (d + 2) x 1: log variance, log 1/range (d), log noise variance;
%         (d + 1) x 1 with NOISE, (d + 3) x 1 with EXTRA: its slope by it
%
% The restricted likelihood equals stk_param_relik up to the prior, in less time
% for few runs. With few runs per parameter the plain likelihood lets the noise
% collapse to zero; the prior costs nothing when the data speak.

function fit = prepareFit (U, y, trend, kernel, noise, of)
  if nargin < 6
    of = struct ('extra', [], 'prior', [], 'scatter', [], 'scale', 1);
  end
  [n, d] = size (U);
  S = zeros (n * n, d);
  for j = 1:d
    S(:, j) = reshape ((U(:, j) - U(:, j)').^2, [], 1);
  end
  H = feval (feval (['stk_lm_' trend]), U);
  [Q, ~] = qr (H);
  fit.S = S;
  fit.W = Q(:, columns (H) + 1:end);
  fit.y = y;
  fit.kernel = kernel;
  fit.noise = noise;
  fit.extra = [];
  beyond = 0.01;
  if strcmp (trend, 'constant')
    beyond = 1;
  end
  [ofNoise, open] = noisePrior (of.scatter, of.scale);
  fit.mean = [log(beyond); -log(1.5) * ones(d, 1); ofNoise];
  fit.sd = [2; ones(d, 1); open];
  if ~isempty (of.prior)
    known = isfinite (of.prior);
    variance = 1 ./ (1 ./ fit.sd(known).^2 + 1 / 0.5^2);
    fit.mean(known) = variance .* (fit.mean(known) ./ fit.sd(known).^2 + ...
                                   of.prior(known) / 0.5^2);
    fit.sd(known) = sqrt (variance);
  end
  if ~isempty (noise)
    fit.mean(end) = [];
    fit.sd(end) = [];
  elseif ~isempty (of.extra)
    fit.extra = of.extra;
    fit.mean(end + 1) = 0;
    fit.sd(end + 1) = 1.5;
  end
  fit.cost = @(theta) penalisedLikelihood (theta, fit);
end

function [C, g] = penalisedLikelihood (theta, fit)
  [n, ~] = size (fit.W);
  d = columns (fit.S);
  variance = exp (theta(1));
  weight = exp (2 * theta(2:d + 1));
  [k, slope] = correlationOf (fit.kernel, fit.S * weight);
  K = variance * reshape (k, n, n);
  if ~isempty (fit.extra)
    noise = exp (theta(end - 1) + theta(end) * fit.extra);
  elseif isempty (fit.noise)
    noise = exp (theta(end)) * ones (n, 1);
  else
    noise = fit.noise;
  end
  G = fit.W' * (K + diag (noise + 1e-12 * variance)) * fit.W;
  [U, bad] = chol ((G + G') / 2);
  if bad
    C = 1e10;
    g = zeros (size (theta));
    return
  end
  F = U' \ fit.W';
  v = F * fit.y;
  u = (theta - fit.mean) ./ fit.sd;
  C = 0.5 * (rows (U) * log (2 * pi) + v' * v + u' * u) + ...
      sum (log (diag (U)));
  if nargout > 1
    z = F' * v;
    M = F' * F - z * z';
    g = zeros (size (theta));
    g(1) = 0.5 * sum (M(:) .* K(:));
    g(2:d + 1) = variance * ((M(:) .* slope)' * fit.S)' .* weight;
    byNoise = 0.5 * noise .* diag (M);
    if ~isempty (fit.extra)
      g(end - 1:end) = [sum(byNoise); byNoise' * fit.extra];
    elseif isempty (fit.noise)
      g(end) = sum (byNoise);
    end
    g = g + u ./ fit.sd;
  end
end

%!shared X, z, names
%! rand ('twister', 1);
%! X = rand (9, 2);
%! z = X(:, 1) - X(:, 2) .^ 2;
%! names = {'matern52', 'matern32', 'gauss'};

%!test
%! U = [0; 0.5; 1];
%! fit = prepareFit (U, [1; 2; 4], 'affine', 'gauss', []);
%! assert (fit.S, reshape ((U - U') .^ 2, 9, 1));
%! assert (fit.W' * [ones(3, 1), U], [0, 0], 1e-12);
%! assert (size (fit.W), [3, 1]);

%!test
%! % the value of stk, for each kernel; gradient against central differences
%! stk = {'stk_materncov52_aniso', 'stk_materncov32_aniso', ...
%!        'stk_gausscov_aniso'};
%! theta = [-1; 0.2; -0.3; -4];
%! for i = 1:3
%!   m = stk_model (stk{i}, 2);
%!   m.lm = stk_lm_affine ();
%!   m.param = theta(1:3);
%!   m.lognoisevariance = -4;
%!   fit = prepareFit (X, z, 'affine', names{i}, []);
%!   u = (theta - fit.mean) ./ fit.sd;
%!   [C, g] = fit.cost (theta);
%!   assert (C - 0.5 * sum (u .^ 2), stk_param_relik (m, X, z), 1e-7);
%!   for j = 1:4
%!     h = 1e-5 * ((1:4)' == j);
%!     dC = fit.cost (theta + h) - fit.cost (theta - h);
%!     assert (g(j), dC / 2e-5, 1e-4);
%!   end
%! end
