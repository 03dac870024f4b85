% PENALISEDLIKELIHOOD  Restricted likelihood of Kriging with a weak prior.
%
% CALL: [C, G] = penalisedLikelihood (THETA, FIT)
%
% THETA  (d + 2) x 1: log variance, log 1/range (d), log noise variance;
%        (d + 1) x 1 when FIT.noise is given, (d + 3) x 1 with FIT.level: its
%        slope by the level
% FIT    struct of prepareFit: S n^2 x d (squared differences), W n x (n - q)
%        (basis orthogonal to the trend), y n x 1, kernel (name), noise n x 1 or
%        [], prior mean and sd (as theta)
% C      scalar, negative log density; G  gradient, as theta
%
% The value equals stk_param_relik up to the prior; written for few runs, where
% the calls around the algebra cost more than the algebra. With few runs per
% parameter the plain likelihood lets the noise collapse to zero; the prior (a
% factor of e and more either way) costs nothing when the data speak.
%
% See also: fitSurrogate, correlationOf

function [C, g] = penalisedLikelihood (theta, fit)
  [n, ~] = size (fit.W);
  d = columns (fit.S);
  variance = exp (theta(1));
  weight = exp (2 * theta(2:d + 1));
  [k, slope] = correlationOf (fit.kernel, fit.S * weight);
  K = variance * reshape (k, n, n);
  if ~isempty (fit.level)
    noise = exp (theta(end - 1) + theta(end) * fit.level);
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
    own = 0.5 * noise .* diag (M);
    if ~isempty (fit.level)
      g(end - 1:end) = [sum(own); own' * fit.level];
    elseif isempty (fit.noise)
      g(end) = sum (own);
    end
    g = g + u ./ fit.sd;
  end
end

%!shared fit, X, z
%! pkg load stk
%! rand ('twister', 1);
%! X = rand (9, 2);
%! z = X(:, 1) - X(:, 2) .^ 2;
%! fit = prepareFit (X, z, 'affine', 'matern52', []);

%!test
%! % the value of stk, for each kernel
%! names = {'matern52', 'matern32', 'gauss'};
%! stk = {'stk_materncov52_aniso', 'stk_materncov32_aniso', ...
%!        'stk_gausscov_aniso'};
%! theta = [-1; 0.2; -0.3; -4];
%! for i = 1:3
%!   m = stk_model (stk{i}, 2);
%!   m.lm = stk_lm_affine ();
%!   m.param = theta(1:3);
%!   m.lognoisevariance = -4;
%!   fit.kernel = names{i};
%!   u = (theta - fit.mean) ./ fit.sd;
%!   C = penalisedLikelihood (theta, fit) - 0.5 * sum (u .^ 2);
%!   assert (C, stk_param_relik (m, X, z), 1e-7);
%! end

%!test
%! % gradient agrees with central differences, for each kernel
%! names = {'matern52', 'matern32', 'gauss'};
%! theta = [-1; 0.2; -0.3; -4];
%! for i = 1:12
%!   fit.kernel = names{mod(i, 3) + 1};
%!   j = mod (i, 4) + 1;
%!   h = 1e-5 * ((1:4)' == j);
%!   [~, g] = penalisedLikelihood (theta, fit);
%!   dC = penalisedLikelihood (theta + h, fit) - ...
%!        penalisedLikelihood (theta - h, fit);
%!   assert (g(j), dC / 2e-5, 1e-4);
%! end
