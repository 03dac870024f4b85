% MIDDLEMARKS  What each effect does at full strength in the middle of the box.
%
% CALL: S = middleMarks (EM, TARGETS)
%
%   EM       emulator, see fitEmulator;  TARGETS  1 x n, targets to look at
%   S        e x n, one effect a row, in units of the targets

function S = middleMarks (em, targets)
  S = zeros (0, numel (targets));
  for e = em.effect
    psi = min (e.scale, e.range(2))^e.bend;
    B = polyRows (e.powers, [zeros(1, em.p), psi]);
    S(end + 1, :) = B * e.coef(:, targets);
  end
end

%!test
%! em = handMadeEmulator ([1, 2, 3; 1, 0, 2]);
%! assert (size (middleMarks (withoutEffects (em), [1, 3])), [0, 2]);
%! em.effect = struct ('powers', [0, 1], 'coef', [4, 5, 6], 'bend', 2, ...
%!                     'range', [0, 3], 'scale', 2);
%! assert (middleMarks (em, [1, 3]), [16, 24]);
