% BOXCENTRE  The set in the middle of the box.
%
% CALL: P = boxCentre (LIMITS)
%
% LIMITS  2 x d, or 3 x d, the box, see toUnit
% P       1 x d

function p = boxCentre (limits)
  p = mean (limits(1:2, :), 1);
  isLog = any (limits(3:end, :), 1);
  p(isLog) = limits(1, isLog) .* sqrt (limits(2, isLog) ./ limits(1, isLog));
end

%!assert (boxCentre ([1, 4; 3, 8]), [2, 6]);
%!assert (boxCentre ([1, 4; 100, 8; 1, 0]), [10, 6]);

% SPDX-License-Identifier: GPL-3.0-only
