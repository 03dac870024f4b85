% FOREIGNVALUES  Turns strengths into values of the effects.
%
% CALL: V = foreignValues (NEUTRAL, LIMITS, PHI)
%
%   NEUTRAL  1 x v, values that switch the effects off
%   LIMITS   2 x v, weakest and strongest values
%   PHI      n x v, strengths
%   V        n x v: NEUTRAL at 0, at 1 the limit further away from it (the upper
%            one where NEUTRAL lies inside the limits), at -1 the lower limit
%
% See also: foreignLab, newEffect

function v = foreignValues (neutral, limits, phi)
  top = limits(2, :);
  isDown = neutral - limits(1, :) > limits(2, :) - neutral & ...
           neutral >= limits(2, :);
  top(isDown) = limits(1, isDown);
  v = neutral + max (phi, 0) .* (top - neutral) + ...
      max (-phi, 0) .* (limits(1, :) - neutral);
end

%!test % upwards, both ways, downwards; neutral to the last digit
%! V = foreignValues ([0, 1, 1], [0, 0.8, 0.1; 5, 1.1, 1], ...
%!                    [0.5, -0.5, 1; 0, 0, 0; 1, 1, 0.5]);
%! assert (V, [2.5, 0.9, 0.1; 0, 1, 1; 5, 1.1, 0.55], 1e-12);
%! assert (V(2, :), [0, 1, 1]);

% SPDX-License-Identifier: GPL-3.0-only
