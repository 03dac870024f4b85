% TWINSSTRENGTH  Weakest strength of an effect that reaches a signal to noise.
%
% CALL: PHI = twinsStrength (LAB, SPACE, K, LEVEL)
%
%   LAB, SPACE  of foreignTwins, twinsSpace;  K  number of the effect
%   LEVEL       scalar, wanted signal to noise (see twinsDraw)
%   PHI         scalar, a multiple of 0.01; 1 where LEVEL is out of reach
%
% Of an effect that acts both ways one side is drawn.
%
% See also: twinsDraw

function phi = twinsStrength (lab, space, k, level)
  K = numel (lab.problem.effects);
  side = 1;
  if lab.isSigned(k) && rand () < 0.5
    side = -1;
  end
  grid = side * (0.01:0.01:1)';
  shapes = lab.means (ones (numel (grid), 1) * space.theta, ...
                      grid * ((1:K) == k)) - space.base;
  first = find (space.visible (shapes) >= level, 1);
  if isempty (first)
    first = numel (grid);
  end
  phi = grid(first);
end

%!test % an effect of signal to noise 4 at full strength
%! lab.means = @(theta, phi) theta * [5, 0] + phi * [3, 4];
%! lab.noise = [1, 1];
%! lab.problem.effects = 1;
%! lab.isSigned = false;
%! space = twinsSpace (lab, 0.3);
%! assert (twinsStrength (lab, space, 1, 3 - 1e-9), 0.75, 1e-12);
%! assert (twinsStrength (lab, space, 1, 9), 1);

% SPDX-License-Identifier: GPL-3.0-only
