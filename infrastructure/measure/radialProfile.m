% RADIALPROFILE  Height of a round heap over the distance from its axis.
%
% CALL: HEIGHT = radialProfile (GRAINS, RADII, CENTRE)
%
% GRAINS  n x 4, columns x y z radius (m), a frame of readDump
% RADII   1 x m, distances from the axis (m)
% CENTRE  1 x 2, where the axis stands, x and y (m; default 0, 0)
% HEIGHT  1 x m, mean over 36 points of the circle of the top of the highest
%         grain (m); a point without a grain counts as 0
%
% See also: surfaceAt, coneLine, readDump
function height = radialProfile (grains, radii, centre)
  if nargin < 3
    centre = [0, 0];
  end
  turn = 2 * pi * (0:35).' / 36;
  x = centre(1) + cos (turn) * radii;
  y = centre(2) + sin (turn) * radii;
  top = surfaceAt (grains, x(:).', y(:).');
  height = mean (reshape (top, size (x)), 1);
end

%!test % one large grain on the axis: its own outline
%! h = radialProfile ([1, 2, 0, 5], [0, 3, 9], [1, 2]);
%! assert (h, [5, 4, 0], 1e-12);
%!assert (radialProfile (zeros (0, 4), [0, 1]), [0, 0])

% SPDX-License-Identifier: GPL-3.0-only
