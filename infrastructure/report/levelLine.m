% LEVELLINE  One line on what a level does to the responses.
%
% CALL: TEXT = levelLine (LEVEL, TARGETS)
%
%   LEVEL    element of levels, see newCalibration
%   TARGETS  1 x T, Case.targets
%   TEXT     the shift of each target with its standard deviation, of a curve
%            the root mean square; at most four targets, the most shifted first

function text = levelLine (level, targets)
  kept = find (~level.dropped(:)');
  [groups, ~, isJoint] = requirementsOf (targets, kept);
  parts = {};
  scalars = [groups{~isJoint}];
  share = abs (level.shift(scalars)(:)') ./ [targets(scalars).tol];
  [~, order] = sort (share, 'descend');
  for t = scalars(order(1:min (end, 4)))
    parts{end + 1} = sprintf ('%s %+.3g +- %.2g', targets(t).name, ...
                              level.shift(t), level.shiftSd(t));
  end
  for group = groups(isJoint)
    rms = sqrt (mean (level.shift(group{1}).^2));
    parts{end + 1} = sprintf ('%s rms %.3g', targets(group{1}(1)).series, rms);
  end
  n = sum (level.dropped);
  if n > 0
    parts{end + 1} = sprintf ('dropped for %d of %s', n, ...
                              countText (numel (targets), 'target'));
  end
  text = strjoin (parts, '; ');
end

%!test
%! targets = struct ('name', {'a', 'b', 'c1', 'c2'}, 'tol', 1, ...
%!                   'curve', {0, 0, 1, 1}, 'series', {'', '', 'c', 'c'});
%! level = struct ('shift', [0.1, -2, 3, 4], 'shiftSd', [1, 1, 1, 1] / 4, ...
%!                 'dropped', false (1, 4));
%! assert (levelLine (level, targets), ...
%!         'b -2 +- 0.25; a +0.1 +- 0.25; c rms 3.54');
%! % as it comes from a file; the order is that of shift over tolerance
%! targets(1).tol = 0.01;
%! level.shift = level.shift';
%! assert (levelLine (level, targets), ...
%!         'a +0.1 +- 0.25; b -2 +- 0.25; c rms 3.54');
%! level.dropped(1) = true;
%! assert (levelLine (level, targets), ...
%!         'b -2 +- 0.25; c rms 3.54; dropped for 1 of 4 targets');

% SPDX-License-Identifier: GPL-3.0-only
