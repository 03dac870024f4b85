% NEUTRALSETS  Sets without an effect that a diagnosis wants.
%
% CALL: N = neutralSets (D, OPTIONS)
%
%   D        scalar, number of parameters
%   OPTIONS  see gapOptions (default: its defaults)
%   N        scalar: OPTIONS.neutral (D + 1), 40 at most
%
% See also: completePlan, gapOptions

function n = neutralSets (d, options)
  if nargin < 2
    options = gapOptions ([]);
  end
  n = min (options.neutral * (d + 1), 40);
end

%!assert (arrayfun (@neutralSets, [4, 12]), [20, 40])
%!assert (neutralSets (4, struct ('neutral', 2)), 10)

% SPDX-License-Identifier: GPL-3.0-only
