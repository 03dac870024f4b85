% NEUTRALSETS  Sets without an effect that a diagnosis wants.
%
% CALL: N = neutralSets (D)
%
%   D  scalar, number of parameters
%   N  scalar: 4 (D + 1), 40 at most
%
% See also: completePlan, gapOptions

function n = neutralSets (d)
  n = min (gapOptions ([]).neutral * (d + 1), 40);
end

%!assert (arrayfun (@neutralSets, [4, 12]), [20, 40])
