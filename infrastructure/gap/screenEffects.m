% SCREENEFFECTS  Tells cheaply which effects could be seen, and told apart.
%
% CALL: SCREEN = screenEffects (WHITE, THETA, Z)
%
%   WHITE   struct of whitenEmulator
%   THETA   1 x p, fitted null model, parameters in [-1, 1]
%   Z       1 x T, whitened data
%   SCREEN  struct
%     parity        struct of parityProjection at THETA
%     U             n x K, signature of each effect at its largest strength,
%                   what parameters can absorb taken out
%     size          1 x K, ||u||: signal to noise at full strength, the noise of
%                   the signature itself taken out
%     absorbedShare 1 x K, part of the signature that parameters absorb
%     smallest      1 x K, smallest strength seen in 80 % of cases at 5 % false
%                   alarms: ||u (phi)|| = 2.49; Inf: cannot be seen
%     strength      1 x K, first estimate of phi;  gain 1 x K, drop of chi2
%     cosine        K x K, isolability: cosines of the signatures
%     directions    n x m, unit vectors of all signatures; sided 1 x m
%
% See also: parityProjection, gateTest, confusion

function screen = screenEffects (white, theta, z)
  [M, V, J] = predictGap (white, [], theta);
  sd = sqrt (V');
  slopes = reshape (vertcat (J{:})', numel (z), white.p) ./ sd;
  screen.parity = parityProjection (slopes, (z - M)' ./ sd);
  K = numel (white.effect);
  T = numel (z);
  N = screen.parity.N;
  screen.U = zeros (columns (N), K);
  blank = zeros (1, K);
  screen.size = blank;
  screen.absorbedShare = blank;
  screen.smallest = blank;
  screen.strength = blank;
  screen.gain = blank;
  screen.directions = zeros (columns (N), 0);
  screen.sided = zeros (1, 0);
  for k = 1:K
    screen = oneEffect (screen, white, k, theta, sd);
  end
  norms = max (sqrt (sum (screen.U.^2, 1)), eps);
  screen.cosine = (screen.U' * screen.U) ./ (norms' * norms);
end

function screen = oneEffect (screen, white, k, theta, sd)
  e = white.effect(k);
  top = e.range(2);
  phi = top * (0.1:0.1:1)';
  Q = [repmat(theta, 10, 1), phi];
  S = (predictGap (white, k, Q) - predictGap (white, [], theta)) ./ sd';
  extra = zeros (10, 1);
  if ~e.laboratory
    V = exp (polyRows (e.varPowers, Q) * e.varCoef);
    extra = phi.^2 .* sum (V ./ sd'.^2, 2);
  end
  N = screen.parity.N;
  U = S * N;
  kept = columns (N) / max (rows (N), 1);
  energy = max (sum (U.^2, 2) - kept * extra, 0);
  screen.U(:, k) = U(end, :)';
  screen.size(k) = sqrt (energy(end));
  whole = sum (S(end, :).^2);
  screen.absorbedShare(k) = 1 - sum (U(end, :).^2) / max (whole, eps);
  seen = find (sqrt (energy) >= 2.49, 1);
  screen.smallest(k) = Inf;
  if ~isempty (seen)
    screen.smallest(k) = phi(seen);
  end
  both = e.range(1) < 0;
  units = U([5, 10], :)' ./ max (sqrt (sum (U([5, 10], :).^2, 2)), eps)';
  screen.directions = [screen.directions, units];
  screen.sided = [screen.sided, ~[both, both]];
  along = units' * screen.parity.rho;
  if ~both
    along = max (along, 0);
  end
  [screen.gain(k), which] = max (along.^2);
  length_ = norm (U(5 * which, :));
  screen.strength(k) = along(which) * phi(5 * which) / max (length_, eps);
end

%!test
%! % one parameter, one effect on the third target alone
%! e = struct ('name', 'x', 'powers', [0, 1], 'coef', [0, 0, 5], ...
%!             'range', [0, 1], 'laboratory', true, 'varPowers', [], ...
%!             'varCoef', []);
%! white = struct ('p', 1, 'powers', [0; 1], 'coef', [0, 0, 0; 2, 1, 0], ...
%!                 'varPowers', 0, 'varCoef', [0, 0, 0], 'effect', e);
%! screen = screenEffects (white, 0, [0, 0, 2.5]);
%! assert (screen.size, 5, 1e-12);
%! assert (screen.strength, 0.5, 1e-12);
%! assert (screen.gain, 2.5 ^ 2, 1e-12);
%! assert (screen.smallest, 0.5, 1e-12);
%! assert (screen.absorbedShare, 0, 1e-12);
