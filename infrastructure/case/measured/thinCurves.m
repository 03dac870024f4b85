% THINCURVES  Leaves out points of curves that are measured more densely than they vary.
%
% CALL: [GROUPS, LEFT] = thinCurves (GROUPS)
%
%   GROUPS  see groupMeasured; of a curve at most 30 of the points to be fitted are
%           kept, evenly along it, with both ends
%   LEFT    1 x n struct array model, name of those that are left out
%
% Neighbouring points of a curve say the same: their errors are alike, and each has a
% surrogate of its own, which costs time. On a curve of 400 points 20 give the same set.

function [groups, left] = thinCurves (groups)
  most = 30;
  isPoint = ~cellfun (@isempty, {groups.series}) & strcmp ({groups.role}, 'calibrate');
  isLeft = false (size (groups));
  keys = arrayfun (@(g) sprintf ('%d|%s', g.model, g.series), groups, ...
                   'UniformOutput', false);
  for key = unique (keys(isPoint))
    mine = find (isPoint & strcmp (keys, key{1}));
    [~, order] = sort ([groups(mine).at]);
    kept = mine(order(unique (round (linspace (1, numel (mine), ...
                                               min (most, numel (mine)))))));
    isLeft(setdiff (mine, kept)) = true;
  end
  left = struct ('model', {groups(isLeft).model}, 'name', {groups(isLeft).name});
  groups = groups(~isLeft);
end

%!function groups = points (n, role)
%!  groups = struct ('model', 1, 'series', 'w', 'at', num2cell (n:-1:1), 'role', role, ...
%!                   'name', 'w');
%!endfunction
%!test
%! single = struct ('model', 1, 'series', '', 'at', NaN, 'role', 'calibrate', 'name', 'a');
%! [groups, left] = thinCurves ([single, points(400, 'calibrate')]);
%! assert (numel (groups), 31);
%! assert (groups(1), single);
%! assert ([max([groups.at]), min([groups.at])], [400, 1]);
%! assert (max (abs (diff ([groups(2:end).at]))) < 16);
%! assert (numel (left), 370);
%! assert (numel (thinCurves (points (30, 'calibrate'))), 30);
%! assert (numel (thinCurves (points (99, 'holdout'))), 99);

% SPDX-License-Identifier: GPL-3.0-only
