% SURFACELINE  Straight line through the surface of grains seen from the side.
%
% CALL: [ANGLE, LINE, POINTS] = surfaceLine (GRAINS, FROM, TO)
%
% GRAINS    n x 4, columns x y z radius (m), a frame of readDump
% FROM, TO  ends of the stretch along x that is fitted (m)
% ANGLE     inclination (deg), positive where the surface rises along x; NaN
%           where the grains cover fewer than 2 of the stations
% LINE      1 x 2, slope and height at x = 0 (m): z = LINE(1) x + LINE(2)
% POINTS    2 x m, what was fitted, x and z (m): silhouette at 60 stations,
%           without those that no grain covers
%
% See also: silhouette, coneLine, readDump
function [angle, line, points] = surfaceLine (grains, from, to)
  x = linspace (from, to, 60);
  z = silhouette (grains, x);
  isCovered = ~isnan (z);
  x = x(isCovered);
  z = z(isCovered);
  line = [NaN, NaN];
  if numel (x) > 1
    line = polyfit (x, z, 1);
  end
  angle = atand (line(1));
  points = [x; z];
end

%!test % grains on a slope of 30 degrees: tops follow it
%! x = (0:0.001:0.1).';
%! grains = [x, 0 * x, x * tand(30), 0.002 + 0 * x];
%! [angle, line, points] = surfaceLine (grains, 0.01, 0.09);
%! assert (angle, 30, 0.2);
%! assert (line(2), 0.002 / cosd (30), 1e-4);
%! assert (size (points), [2, 60]);
%! assert (mean (points(2, :) - polyval (line, points(1, :))), 0, 1e-12);
%!test % turned round it falls; nothing there: NaN
%! assert (surfaceLine ([0, 0, 1, 1; 1, 0, 0, 1], 0, 1) < 0);
%! [angle, ~, points] = surfaceLine (zeros (0, 4), 0, 1);
%! assert (isnan (angle) && isempty (points));

% SPDX-License-Identifier: GPL-3.0-only
