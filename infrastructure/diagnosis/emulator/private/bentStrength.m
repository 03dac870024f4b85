% BENTSTRENGTH  Strength on the scale on which an effect acts as a polynomial.
%
% CALL: PSI = bentStrength (PHI, BEND)
%
%   PHI   n x K, strengths;  BEND  1 x K or scalar, exponents of learnEffect
%   PSI   n x K: sign (PHI) |PHI|^BEND
%
% A force of attraction grows with a power of what causes it (JKR: work of
% adhesion; capillary bridges saturate with the volume): with the bend, terms of
% third order are enough.

function psi = bentStrength (phi, bend)
  psi = sign (phi) .* abs (phi).^bend;
end

%!assert (bentStrength ([-0.25, 0, 1], 0.5), [-0.5, 0, 1])

% SPDX-License-Identifier: GPL-3.0-only
