% FLANKANGLES  Angle of repose from the two flanks of a heap seen from the side.
%
% CALL: HEAP = flankAngles (X, Z)
%
%   X, Z  1 x n, stations (rising) and height of the surface above the base there,
%         in the same unit: of silhouette for grains, of pictureOutline for a
%         picture; NaN where nothing is seen
%   HEAP  scalar struct: angle (deg, mean of both flanks), sd (its standard
%         uncertainty), left, right (deg, one a flank), difference (left less
%         right; twice the roll of a camera shows here and not in the mean),
%         height, radius (of the base, where the flanks meet it), radiusSd; NaN
%         where a flank has fewer than 5 stations
%
% The height is the median of the highest twentieth of the stations above half of
% the maximum. A flank is what lies between 20 % and 80 % of it, chosen by the
% stations, not by the heights, so that bumps of grains do not tilt the line: foot
% and rounded tip are left out. The uncertainty is the larger one of half of the
% difference and that of the two lines (lineWithSd).
%
% See also: silhouette, pictureOutline, surfaceLine

function heap = flankAngles (x, z)
  z(isnan (z)) = 0;
  heap = struct ('angle', NaN, 'sd', NaN, 'left', NaN, 'right', NaN, ...
                 'difference', NaN, 'height', NaN, 'radius', NaN, ...
                 'radiusSd', NaN);
  if ~any (z > 0)
    return
  end
  high = sort (z(z > max (z) / 2), 'descend');
  height = median (high(1:ceil (numel (high) / 20)));
  heap.height = height;
  tip = round (mean (find (z > 0.9 * height)));
  [left, leftSd, leftFoot] = flankLine (x(1:tip), z(1:tip), height);
  [right, rightSd, rightFoot] = flankLine (-fliplr (x(tip:end)), ...
                                           fliplr (z(tip:end)), height);
  heap.left = left;
  heap.right = right;
  heap.difference = left - right;
  heap.angle = (left + right) / 2;
  heap.sd = max (abs (heap.difference) / 2, hypot (leftSd, rightSd) / 2);
  heap.radius = (-rightFoot(1) - leftFoot(1)) / 2;
  heap.radiusSd = hypot (leftFoot(2), rightFoot(2)) / 2;
end

%!function [x, z] = drawn (left, right, bump)
%!  % heap of height 1 with rounded tip and foot, bumps of grains of 0.05
%!  x = linspace (-3, 3, 900);
%!  z = max (0, min (1 - max (0, -x * tand (left)), 1 - max (0, x * tand (right))));
%!  z = conv (z, ones (1, 15) / 15, 'same') + ...
%!      bump * (z > 0) .* conv (randn (size (x)), ones (1, 8) / sqrt (8), 'same');
%!endfunction
%!test
%! [x, z] = drawn (34, 30, 0);
%! heap = flankAngles (x, z);
%! assert ([heap.left, heap.right, heap.angle, heap.difference], ...
%!         [34, 30, 32, 4], 0.05);
%! assert (heap.sd, 2, 0.05);
%! assert (heap.radius, (1 / tand (34) + 1 / tand (30)) / 2, 0.01);
%! assert (heap.height, 1, 0.05);
%!test
%! % 200 drawn heaps with bumps of 3 % of the height: bias below 0.15 deg;
%! % the uncertainty is 1 to 1.5 times the scatter
%! seeds = randn ('state');
%! randn ('state', 11);
%! found = zeros (200, 3);
%! for k = 1:200
%!   [x, z] = drawn (30, 30, 0.03);
%!   heap = flankAngles (x, z);
%!   found(k, :) = [heap.angle, heap.sd, heap.radius];
%! end
%! randn ('state', seeds);
%! assert (mean (found(:, 1)), 30, 0.15);
%! assert (sqrt (mean (found(:, 2).^2)) / std (found(:, 1)), 1.25, 0.25);
%! assert (mean (found(:, 3)), 1 / tand (30), 0.02);
%!assert (isnan (flankAngles (1:9, zeros (1, 9)).angle))
%!assert (isnan (flankAngles (1:4, [0, 1, 1, 0]).angle))
%!test
%! % the same rule for grains and for a picture of them: a drawn heap of 3,000
%! % grains, read as a frame and as a picture, within 1 deg
%! state = rand ('state');
%! rand ('state', 3);
%! n = 3000;
%! r = 0.002;
%! where = 0.1 * (2 * rand (n, 1) - 1);
%! grains = [where, zeros(n, 1), ...
%!           (0.1 - abs(where)) * tand(28) .* sqrt(rand (n, 1)), repmat(r, n, 1)];
%! rand ('state', state);
%! x = linspace (-0.12, 0.12, 600);
%! ofRun = flankAngles (x, silhouette (grains, x));
%! [X, Y] = meshgrid (x, 0.08 - (0:249) * (x(2) - x(1)));
%! isIn = false (size (X));
%! for g = grains'
%!   isIn |= (X - g(1)).^2 + (Y - g(3)).^2 < r^2;
%! end
%! file = [tempname(), '.png'];
%! imwrite (uint8 (230 - 180 * isIn), file);
%! [x, z] = pictureOutline (file);
%! unlink (file);
%! ofPhoto = flankAngles (x, z);
%! assert (ofPhoto.angle, ofRun.angle, 1);
%! assert (ofRun.angle, 28, 1);

% SPDX-License-Identifier: GPL-3.0-only
