% FLANKLINE  Straight line through a flank that rises along X.
%
% CALL: [ANGLE, SD, FOOT] = flankLine (X, Z, HEIGHT)
%
%   X, Z    1 x n, stations (rising) and heights above the base
%   HEIGHT  of the heap; the flank is what lies between 20 % and 80 % of it
%   ANGLE   deg;  SD  its standard uncertainty;  FOOT  1 x 2, place where the line
%           meets the base, and the standard uncertainty of that; NaN for a flank of
%           fewer than 5 stations
%
% See also: flankAngles, drawDownFaces

function [angle, sd, foot] = flankLine (x, z, height)
  [angle, sd, foot] = deal (NaN, NaN, [NaN, NaN]);
  k = crossing (z, 0.2 * height):crossing (z, 0.8 * height);
  if numel (k) < 5
    return
  end
  [angle, sd, line] = lineWithSd (x(k), z(k));
  run = line.height / line.slope;
  footSd = hypot (sqrt (line.heightVar), run * sqrt (line.slopeVar)) / line.slope;
  foot = [line.middle - run, footSd];
end

% Bumps cross a height several times: the middle of the first and the last time.
function k = crossing (z, height)
  first = find (z >= height, 1);
  last = find (z < height, 1, 'last');
  k = max (1, round (mean ([first, last])));
end

%!test
%! x = linspace (-2, 2, 400);
%! [angle, sd, foot] = flankLine (x, min (1, max (0, x + 1)), 1);
%! assert ([angle, sd, foot(1)], [45, 0, -1], 1e-6);

% SPDX-License-Identifier: GPL-3.0-only
