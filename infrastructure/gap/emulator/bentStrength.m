% BENTSTRENGTH  Bends strengths: sign (phi) |phi|^bend.
%
% CALL: PSI = bentStrength (PHI, BEND)
%
%   PHI   n x h, strengths;  BEND  scalar or 1 x h, exponents
%   PSI   n x h
%
% See also: learnEffect, predictGap

function psi = bentStrength (phi, bend)
  psi = sign (phi) .* abs (phi).^bend;
end

%!assert (bentStrength ([-0.25, 0.5], [0.5, 2]), [-0.5, 0.25])
