% SHOWNTARGETS  Targets that the report draws one by one.
%
% CALL: [SHOWN, N] = shownTargets (CASE)
%
%   CASE   see newCase
%   SHOWN  1 x n, numbers of targets: all but the points of curves, and of each
%          curve the first one, the middle one and the last one
%   N      how many points of curves there are

function [shown, n] = shownTargets (Case)
  [groups, ~, isJoint] = requirementsOf (Case.targets, 1:numel (Case.targets));
  n = numel ([groups{isJoint}]);
  shown = [zeros(1, 0), groups{~isJoint}];
  for group = groups(isJoint)
    points = group{1};
    [~, order] = sort ([Case.targets(points).at]);
    few = round (linspace (1, numel (points), min (3, numel (points))));
    shown = union (shown, points(order(few)));
  end
end

%!test
%! Case.targets = struct ('curve', {0, 1, 1, 1, 1, 1, 2}, ...
%!                        'at', {NaN, 5, 4, 3, 2, 1, 7});
%! assert (shownTargets (Case), [1, 2, 4, 6, 7]);
%! % all of them points: a row, as the caller goes through it
%! Case.targets = struct ('curve', {1, 1, 1, 1}, 'at', {1, 2, 3, 4});
%! assert (shownTargets (Case), [1, 3, 4]);

% SPDX-License-Identifier: GPL-3.0-only
