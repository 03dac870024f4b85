% POOLEDNOISE  Improves the noise of each response by the runs of effects.
%
% CALL: [VARIANCE, FREEDOM] = pooledNoise (EMULATOR, EFFECTS)
%
%   EMULATOR  struct of fitEmulator: noiseVar and noiseFreedom (1 x T, as
%             repeats and the nugget tell; Inf: known)
%   EFFECTS   1 x K struct array of learnEffect
%   VARIANCE, FREEDOM   1 x T, both with what the scatter of the effects' runs
%             around their own surrogates says
%
% A nugget from 40 runs errs by a factor of two and is a quarter too small on
% average; the runs of ten effects are four times as many. The marginal
% likelihood of every effect is taken at several factors on the noise; their
% product with the density of the nugget (log variance normal, variance 8 /
% freedom: it errs twice as much as it claims) gives the mean and, by its width,
% the freedom.

function [variance, freedom] = pooledNoise (emulator, effects)
  factors = 2.^(-2:0.5:2.5);
  x = log (factors);
  score = -emulator.noiseFreedom' / 16 .* x.^2;
  for e = effects(~[effects.laboratory] & [effects.runs] >= 6)
    score = score + scoresOf (emulator, e, factors);
  end
  w = exp (score - max (score, [], 2));
  w = w ./ sum (w, 2);
  middle = sum (w .* x, 2)';
  % and what the steps of the grid leave open, as of a uniform density
  spread = sum (w .* (x - middle').^2, 2)' + diff (x)(1)^2 / 12;
  % mean of a log-normal density, and the freedom that has its width
  variance = emulator.noiseVar .* exp (middle + spread / 2);
  freedom = 2 ./ spread;
  known = isinf (emulator.noiseFreedom);
  variance(known) = emulator.noiseVar(known);
  freedom(known) = Inf;
end

% Log marginal likelihood of the runs of effect E: T x number of factors.
function score = scoresOf (emulator, e, factors)
  coarse = struct ('decay', [0.1, 0.5], 'misfit', [0, 8]);
  Q = e.Q;
  Q(:, end) = bentStrength (Q(:, end), e.bend);
  score = zeros (columns (e.R), numel (factors));
  for t = find (sum (isfinite (e.R), 1) >= 6)
    ok = isfinite (e.R(:, t));
    r = [e.R(ok, t), Q(ok, end)];
    for f = 1:numel (factors)
      fit = fitEffect (e.powers, Q(ok, :), r, factors(f) * emulator.noiseVar(t), ...
                       reshape (e.variance(ok, t, :), [], 2), coarse);
      score(t, f) = fit.score;
    end
  end
end

%!test
%! % a nugget four times too small is put right by 60 runs (seeded)
%! rand ('twister', 5); randn ('twister', 5);
%! emulator = struct ('p', 1, 'coef', zeros (3, 2), 'powers', [0; 1; 2], ...
%!              'noiseVar', [0.0025, 0.01], 'noiseFreedom', [6, Inf]);
%! emulator.range = [1, 1];
%! emulator.correlation = eye (2);
%! emulator.levelShare = 0;
%! effect = struct ('name', 'e', 'range', [0, 1], 'scale', 0.5, ...
%!                  'laboratory', false);
%! for k = 1:3
%!   Q = [2 * rand(20, 1) - 1, 0.1 + 0.9 * rand(20, 1)];
%!   Z = k * Q(:, 2) .* [1, 2] + 0.1 * randn (20, 2);
%!   runs = struct ('theta', Q(:, 1), 'phi', Q(:, 2), 'Z', Z, ...
%!                  'mean', 0 * Z, 'variance', 0 * Z, ...
%!                 'level', 0 * Z);
%!   effects(k) = learnEffect (emulator, effect, runs);
%! end
%! [variance, freedom] = pooledNoise (emulator, effects);
%! assert (variance(1) > 0.006 && variance(1) < 0.016);
%! assert (freedom(1) > 8);
%! assert (variance(2), 0.01);

% SPDX-License-Identifier: GPL-3.0-only
