% MIDDLEMARKS  What each effect does at full strength in the middle of the box.
%
% CALL: S = middleMarks (EMULATOR, TARGETS)
%
%   EMULATOR  emulator, see fitEmulator;  TARGETS  1 x n, targets to look at
%   S        e x n, one effect a row, in units of the targets

function S = middleMarks (emulator, targets)
  S = zeros (0, numel (targets));
  for e = emulator.effect
    psi = min (e.scale, e.range(2))^e.bend;
    B = polyRows (e.powers, [zeros(1, emulator.p), psi]);
    S(end + 1, :) = B * e.coef(:, targets);
  end
end

%!test
%! emulator = handMadeEmulator ([1, 2, 3; 1, 0, 2]);
%! assert (size (middleMarks (withoutEffects (emulator), [1, 3])), [0, 2]);
%! emulator.effect = struct ('powers', [0, 1], 'coef', [4, 5, 6], 'bend', 2, ...
%!                     'range', [0, 3], 'scale', 2);
%! assert (middleMarks (emulator, [1, 3]), [16, 24]);

% SPDX-License-Identifier: GPL-3.0-only
