% SCREENEFFECTS  Tells cheaply which effects could be seen, and told apart.
%
% CALL: SCREEN = screenEffects (WHITE, THETA, Z)
% CALL: SCREEN = screenEffects (WHITE, THETA)
%
%   WHITE   struct of whitenEmulator
%   THETA   1 x p, calibrated null model, parameters in [-1, 1]
%   Z       1 x T, whitened data; without them only full strength is looked at,
%           and smallest, strength and gain say nothing
%   SCREEN  struct
%     parity        struct of parityProjection at THETA
%     U             n x K, signature of each effect at full strength, what
%                   parameters can absorb taken out
%     size          1 x K, ||u||: signal to noise at full strength (of an effect
%                   that acts both ways: on the side that is seen better), the
%                   noise of the signature itself taken out
%     absorbedShare 1 x K, part of the signature that parameters absorb
%     smallest      1 x K, smallest |strength| seen in 80 % of cases at 5 %
%                   false alarms: ||u (phi)|| = 2.49; Inf: cannot be seen
%     strength      1 x K, first estimate of phi;  gain 1 x K, drop of chi2
%     cosine        K x K, isolability: cosines of the signatures, their
%                   absolute values where one of the two acts both ways

function screen = screenEffects (white, theta, z)
  [M, V, ~, J] = predictGap (white, [], theta);
  sd = sqrt (V');
  steps = (0.05:0.05:1)';
  if nargin < 3
    z = M;
    steps = 1;
  end
  slopes = reshape (vertcat (J{:})', numel (z), white.p) ./ sd;
  screen.parity = parityProjection (slopes, (z - M)' ./ sd);
  K = numel (white.effect);
  blank = zeros (1, K);
  screen.U = zeros (columns (screen.parity.N), K);
  [screen.size, screen.absorbedShare, screen.strength, screen.gain] = ...
    deal (blank);
  screen.smallest = blank + Inf;
  both = false (1, K);
  for k = 1:K
    range = white.effect(k).range;
    both(k) = range(1) < 0;
    screen = oneSide (screen, white, k, range(2) * steps, theta, sd);
    if both(k)
      screen = oneSide (screen, white, k, range(1) * steps, theta, sd);
    end
  end
  unit = screen.U ./ max (sqrt (sum (screen.U.^2, 1)), realmin);
  screen.cosine = unit' * unit;
  % what acts both ways does the opposite of the other one as well
  either = both | both';
  screen.cosine(either) = abs (screen.cosine(either));
end

% At strengths PHI up to the end of the range; what the other side showed better
% stays.
function screen = oneSide (screen, white, k, phi, theta, sd)
  n = numel (phi);
  [~, V, S] = predictGap (white, k, [repmat(theta, n, 1), phi]);
  S = S ./ sd';
  extra = sum (V ./ sd'.^2 - 1, 2);
  N = screen.parity.N;
  U = S * N;
  kept = columns (N) / max (rows (N), 1);
  energy = max (sum (U.^2, 2) - kept * extra, 0);
  % 1.645 + 0.842: one-sided 5 %, and 80 % of the cases
  seen = find (sqrt (energy) >= 2.49, 1);
  if ~isempty (seen)
    screen.smallest(k) = min (screen.smallest(k), abs (phi(seen)));
  end
  if sqrt (energy(end)) >= screen.size(k)
    screen.U(:, k) = U(end, :)';
    screen.size(k) = sqrt (energy(end));
    whole = sum (S(end, :).^2);
    screen.absorbedShare(k) = 1 - sum (U(end, :).^2) / max (whole, realmin);
  end
  length_ = max (sqrt (sum (U.^2, 2)), realmin);
  along = max (U * screen.parity.rho ./ length_, 0);
  % drop of chi2 by this mark times a factor of 0 to 1
  gain = along.^2 - max (along - length_, 0).^2;
  [most, at] = max (gain);
  if most > screen.gain(k)
    screen.gain(k) = most;
    screen.strength(k) = phi(at);
  end
end

%!test
%! white = handMadeHypotheses ().white;
%! screen = screenEffects (white, 0.5, [1.5, 0.5, 3, 3]);
%! assert (screen.size, [4 * sqrt(2), 4], 1e-9);
%! assert (screen.cosine(1, 2), -1 / sqrt (2), 1e-9);
%! assert (screen.strength(1), 0.75, 1e-9);
%! assert (screen.gain(1), 18, 1e-9);
%! assert (screen.gain(2), 0);
%! assert (screen.smallest(1), 0.45, 1e-9);
%!test
%! % an effect that acts both ways: its sign does not matter for likeness, and
%! % one that is plain on the negative side only is seen
%! white = handMadeHypotheses ().white;
%! white.effect(2).range = [-1, 0.1];
%! screen = screenEffects (white, 0.5, [1.5, 0.5, 0, 3.6]);
%! assert (screen.cosine(1, 2), 1 / sqrt (2), 1e-9);
%! assert (screen.size(2), 4, 1e-9);
%! assert (screen.strength(2), -0.9, 1e-9);
%! assert (isfinite (screen.smallest(2)));

% SPDX-License-Identifier: GPL-3.0-only
