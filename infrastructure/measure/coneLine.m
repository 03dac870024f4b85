% CONELINE  Angle of repose of a round heap, and its apex.
%
% CALL: [ANGLE, APEX, POINTS] = coneLine (GRAINS, FROM, TO, CENTRE)
%
% GRAINS    n x 4, columns x y z radius (m), a frame of readDump
% FROM, TO  distances from the axis between which the flank is fitted (m)
% CENTRE    1 x 2, where the axis stands, x and y (m; default 0, 0)
% ANGLE     inclination of the flank (deg), positive for a heap, negative for
%           a hollow
% APEX      height of the fitted cone on the axis (m)
% POINTS    2 x 13, what was fitted: distance from the axis and, of
%           radialProfile, height (m)
%
% See also: radialProfile, surfaceLine, readDump
function [angle, apex, points] = coneLine (grains, from, to, centre)
  if nargin < 4
    centre = [0, 0];
  end
  r = linspace (from, to, 13);
  z = radialProfile (grains, r, centre);
  line = polyfit (r, z, 1);
  angle = atand (-line(1));
  apex = line(2);
  points = [r; z];
end

%!test % many small grains on a cone of 25 degrees, off the origin
%! [x, y] = meshgrid (-0.05:0.0008:0.05);
%! z = 0.03 - hypot (x, y) * tand (25);
%! grains = [x(:) + 0.2, y(:) - 0.1, z(:), 0.001 + 0 * z(:)];
%! [angle, apex, points] = coneLine (grains, 0.01, 0.04, [0.2, -0.1]);
%! assert (angle, 25, 0.3);
%! assert (apex, 0.03 + 0.001 / cosd (25), 2e-4);
%! assert (points(1, [1, end]), [0.01, 0.04], 1e-12);

% SPDX-License-Identifier: GPL-3.0-only
