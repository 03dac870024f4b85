% HANDMADEEMULATOR  An emulator of one parameter, nothing unknown, for tests.
%
% CALL: EMULATOR = handMadeEmulator (COEF)
%
%   COEF  2 x T, mean of each result at the middle of the box, and its slope
%   EMULATOR  struct as of fitEmulator: one bench, runs of noise 1, surrogates that
%         are exact, no effects
%
% See also: fitEmulator, handMadeHypotheses

function emulator = handMadeEmulator (coef)
  T = columns (coef);
  one = ones (1, T);
  emulator = struct ('p', 1, 'powers', [0; 1], 'coef', coef, 'bench', one, ...
                     'points', [-1; 0; 1], 'surrogateVar', zeros (3, T), ...
                     'varPowers', 0, 'fitVar', 0 * one, 'noiseVar', one, ...
                     'noiseFreedom', Inf * one, 'correlation', eye (T), ...
                     'misfitLikeness', eye (T), 'range', one, 'success', ...
                     zeros (2, 1), 'change', [], 'known', []);
  emulator.effect = struct ('name', {}, 'laboratory', {});
  emulator.joint = emulator.effect;
end

%!assert (handMadeEmulator (ones (2, 3)).range, [1, 1, 1])

% SPDX-License-Identifier: GPL-3.0-only
