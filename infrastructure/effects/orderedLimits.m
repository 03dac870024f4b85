% ORDEREDLIMITS  Limits of an effect, lower one first where it acts both ways.
%
% CALL: LIMITS = orderedLimits (LIMITS, NEUTRAL)
%
% LIMITS   2 x v, as the user gives them
% NEUTRAL  1 x v
%
% Where neutral lies at an end or outside, the rows stay: weakest, strongest.
function limits = orderedLimits (limits, neutral)
  both = min (limits, [], 1) < neutral & neutral < max (limits, [], 1);
  limits(:, both) = sort (limits(:, both), 1);
end

%!assert (orderedLimits ([0.9, 3; 0.2, 1], [0.5, 5]), [0.2, 3; 0.9, 1])

% SPDX-License-Identifier: GPL-3.0-only
