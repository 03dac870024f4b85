% MISSEDTARGETS  Names the targets that are missed by more than noise makes.
%
% CALL: NAMES = missedTargets (GAP, ROLES)
%
%   GAP    struct as of gap.json: thresholds, where.targets with name, role and p
%   ROLES  text or cellstr, of the targets to look at
%   NAMES  1 x n cell; the points of a curve, NAME@AT, are one: 'discharge (3 of
%          50 points, 0.2 to 2.75)'
%
% See also: decideGap

function names = missedTargets (gap, roles)
  targets = jsonList (gap, {'where', 'targets'});
  targets = targets(cellfun (@(T) any (strcmp (T.role, roles)), targets));
  isOff = cellfun (@(T) any (jsonAt (T, {'p'}) < gap.thresholds.level), targets);
  names = {};
  if ~any (isOff)
    return
  end
  names = eachOf (@(T) T.name, targets);
  [series, at] = strtok (names, '@');
  at = cellfun (@(t) str2double (t(2:end)), at);
  for name = unique (series(isfinite (at)))
    points = strcmp (series, name{1}) & isfinite (at);
    if sum (points) >= 3 && any (points & isOff)
      off = at(points & isOff);
      values = struct ('name', name{1}, 'n', numel (off), 'of', sum (points), ...
                       'from', min (off), 'to', max (off));
      names(points) = {sentence(['curve.', merge(isscalar (off), 'point', 'points')], values)};
    end
  end
  names = unique (names(isOff), 'stable');
end

%!test
%! % two curves, the second one of two points; a single target; one held out
%! name = {'c@1', 'x', 'c@2.5', 'c@4', 'd@1', 'd@2', 'y'};
%! p = num2cell ([0.01, 0.02, 0.5, 0.04, 0.01, 0.3, 0.01]);
%! role = [repmat({'calibrate'}, 1, 6), {'holdout'}];
%! gap.thresholds.level = 0.05;
%! gap.where.targets = struct ('name', name, 'role', role, 'p', p);
%! assert (missedTargets (gap, 'calibrate'), ...
%!         {'c (2 of 3 points, 1 to 4)', 'x', 'd@1'});
%! gap.where.targets(1).p = 0.5;
%! assert (missedTargets (gap, 'calibrate'){2}, 'c (1 of 3 points, at 4)');
%! assert (missedTargets (gap, {'calibrate', 'holdout'}){end}, 'y');
%! assert (missedTargets (gap, 'other'), {});

% SPDX-License-Identifier: GPL-3.0-only
