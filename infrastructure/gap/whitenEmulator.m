% WHITENEMULATOR  Turns an emulator into independent unit-variance coordinates.
%
% CALL: WHITE = whitenEmulator (EM, COLUMNS, NOISE, ROTATION)
%
%   EM        struct of fitEmulator
%   COLUMNS   1 x n, targets to look at
%   NOISE     T x T, covariance of what a surrogate does not cause: measurement
%             and seed (noiseBudget)
%   ROTATION  n x n orthogonal, applied after whitening (default: none)
%   WHITE     struct like EM, results replaced by z = (y(COLUMNS)) * W', plus
%     W (n x n), columns, varCoef (log variance of z), effect.varCoef
%     (log of the extra variance / phi^2)
%
% W whitens NOISE plus the mean surrogate variance, so a variance of z is near 1
% and only its change over the box is modelled (quadratic in the logarithm,
% correlations of z neglected).
%
% See also: fitEmulator, predictGap, noiseBudget

function white = whitenEmulator (em, targets, noise, rotation)
  n = numel (targets);
  fixed = noise(targets, targets) + diag (em.fitVar(targets));
  D = sqrt (em.surrogateVar(:, targets));
  C = em.correlation(targets, targets);
  meanD = sqrt (mean (D.^2, 1));
  W = inv (chol (fixed + (meanD' * meanD) .* C, 'lower'));
  if nargin > 3
    W = rotation * W;
  end
  white = struct ('p', em.p, 'powers', em.powers, 'W', W, ...
                  'columns', targets, 'varPowers', em.varPowers);
  white.coef = em.coef(:, targets) * W';
  V = zeros (rows (D), n);
  base = sum ((W * fixed) .* W, 2)';
  for i = 1:n
    weighted = D .* W(i, :);
    V(:, i) = base(i) + sum ((weighted * C) .* weighted, 2);
  end
  white.varCoef = polyRows (em.varPowers, em.points) \ log (V);
  white.effect = arrayfun (@(e) oneEffect (e, targets, W), em.effect);
end

function e = oneEffect (e, targets, W)
  e.coef = e.coef(:, targets) * W';
  V = e.varOverPhi2(:, targets) * (W.^2)';
  e.varCoef = polyRows (e.varPowers, e.points) \ log (max (V, 1e-12));
end

%!test
%! % two correlated targets become independent ones of unit variance
%! em = struct ('p', 1, 'powers', [0; 1], 'coef', [1, 2; 1, 0], ...
%!              'varPowers', [0; 1], 'points', [-1; 0; 1], ...
%!              'surrogateVar', zeros (3, 2), 'fitVar', [0, 0], ...
%!              'correlation', eye (2), 'effect', []);
%! em.effect = repmat (struct ('name', ''), 1, 0);
%! noise = [4, 1; 1, 1];
%! white = whitenEmulator (em, 1:2, noise);
%! assert (white.W * noise * white.W', eye (2), 1e-12);
%! [M, V] = predictGap (white, [], 0.5);
%! assert (M, [1.5, 2] * white.W', 1e-12);
%! assert (V, [1, 1], 1e-9);
