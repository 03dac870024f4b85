% FITEFFECT  Learns what one effect adds to one response, zero at neutral.
%
% CALL: FIT = fitEffect (POWERS, Q, R, NOISE)
%
%   POWERS  q x (p+1), monomials in (theta, phi), phi in each of them
%   Q       n x (p+1), runs: parameters in [-1, 1] and strength phi
%   R       n x 1, result minus the mean of the baseline surrogate
%   NOISE   n x 1, variance of R: seed and baseline surrogate
%   FIT     struct: coef (q x 1), covariance (q x q, of the coefficients),
%           looStd (n x 1, standardised leave-one-out residuals)
%
% Kriging with a polynomial covariance: R = B coef + noise, coef ~ N (0, s
% diag (g .^ (degree - 1))). Every monomial holds phi, so the effect is exactly
% zero at neutral and the null model stays nested in the model with the effect.
% s, g and a factor on NOISE maximise the marginal likelihood; a singular value
% decomposition makes each trial cheap (Rasmussen and Williams 2006, 2.7, 5.4).
%
% Errors: DEcalioc:fitEffect:badShape
%
% See also: fitEmulator

function fit = fitEffect (powers, Q, r, noise)
  if rows (Q) ~= numel (r) || numel (noise) ~= numel (r)
    error ('DEcalioc:fitEffect:badShape', ...
           ['fitEffect: Q, R and NOISE must have equal numbers of rows, ' ...
            'got %d, %d and %d.'], rows (Q), numel (r), numel (noise));
  end
  root = 1 ./ sqrt (noise(:));
  B = polyRows (powers, Q) .* root;
  y = r(:) .* root;
  degree = sum (powers, 2) - 1;
  best.score = -Inf;
  for g = [0.03, 0.1, 0.3, 1]
    best = better (best, B, y, sqrt (g.^degree(:)'));
  end
  fit = posterior (best, B, y);
end

function best = better (best, B, y, weight)
  [U, S, V] = svd (B .* weight, 'econ');
  s = diag (S)'.^2;
  part = (U' * y)'.^2;
  rest = max (y' * y - sum (part), 0);
  nRest = numel (y) - numel (s);
  top = max (max (s), eps);
  for factor = [1, 2, 4]
    for scale = [0, 4.^(-8:8)] * max (y' * y / top, 1 / top)
      spread = factor + scale * s;
      score = -0.5 * (sum (log (spread) + part ./ spread) + ...
                      nRest * log (factor) + rest / factor) - ...
              log (factor) - 0.01 * log1p (scale)^2;
      if score > best.score
        best = struct ('score', score, 'scale', scale, 'factor', factor, ...
                       'V', V, 's', s, 'weight', weight);
      end
    end
  end
end

function fit = posterior (best, B, y)
  n = numel (y);
  spread = best.factor + best.scale * best.s;
  half = best.V .* best.weight';
  full = best.scale * diag (best.weight.^2);
  shrink = best.scale^2 * best.s ./ spread;
  fit.covariance = full - (half .* shrink) * half';
  K = best.factor * eye (n) + B * full * B';
  inverse = inv (K);
  alpha = inverse * y;
  fit.coef = full * B' * alpha;
  fit.looStd = alpha ./ sqrt (diag (inverse));
end

%!test
%! % a noiseless product is learned; neutral gives zero by construction
%! rand ('twister', 1); randn ('twister', 1);
%! powers = polyPowers (2, 3);
%! powers = powers(powers(:, 2) > 0, :);
%! Q = [2 * rand(25, 1) - 1, rand(25, 1)];
%! r = 2 * Q(:, 2) + Q(:, 1) .* Q(:, 2);
%! fit = fitEffect (powers, Q, r, 1e-6 * ones (25, 1));
%! assert (polyRows (powers, [0.5, 1]) * fit.coef, 2.5, 0.01);
%! assert (polyRows (powers, [0.5, 0]) * fit.coef, 0);
%!test
%! % pure noise: the strength stays within four of its own deviations (seeded)
%! rand ('twister', 1); randn ('twister', 1);
%! Q = [2 * rand(30, 1) - 1, rand(30, 1)];
%! fit = fitEffect ([0, 1; 1, 1], Q, randn (30, 1), ones (30, 1));
%! b = polyRows ([0, 1; 1, 1], [0, 1]);
%! assert (abs (b * fit.coef) < 4 * sqrt (b * fit.covariance * b') + 0.1);
%!test
%! % posterior equals the textbook ridge formula
%! B = [1; 2]; noise = [1; 1];
%! fit = fitEffect ([0, 1], [0, 1; 0, 2], [10; 20], noise);
%! assert (fit.coef, 10, 0.2);
%!error id=DEcalioc:fitEffect:badShape fitEffect ([0, 1], [0, 1], [1; 2], 1)
