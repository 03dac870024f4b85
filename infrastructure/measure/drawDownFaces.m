% DRAWDOWNFACES  Angles of the two faces that a discharge leaves in a bed.
%
% CALL: FACES = drawDownFaces (X, Z)
%
%   X, Z   1 x n, stations (rising) and height of the surface there, same unit;
%          NaN or 0 where the bottom shows
%   FACES  scalar struct: angle (deg, mean of both faces), sd, left (the face that
%          falls along X), right (the one that rises), difference (left less right),
%          depth (1 x 2, of the lowest place below the bed on either side), width
%          (between the places where the faces meet the bed), widthSd
%
% The same rule as for the flanks of a heap, turned upside down: between 20 % and 80
% % of the depth below the bed of that side, its median twentieth at the top.
%
% See also: flankLine, flankAngles, silhouette

function faces = drawDownFaces (x, z)
  z(isnan (z)) = 0;
  faces = struct ('angle', NaN, 'sd', NaN, 'left', NaN, 'right', NaN, ...
                  'difference', NaN, 'depth', [NaN, NaN], 'width', NaN, 'widthSd', NaN);
  low = min (z);
  if max (z) <= low
    return
  end
  tip = round (mean (find (z < low + 0.1 * (max (z) - low))));
  [left, leftSd, leftFoot, depth] = faceOf (x(1:tip), z(1:tip), low);
  [right, rightSd, rightFoot, depth(2)] = faceOf (-fliplr (x(tip:end)), ...
                                                  fliplr (z(tip:end)), low);
  [faces.left, faces.right, faces.depth] = deal (left, right, depth);
  faces.difference = left - right;
  faces.angle = (left + right) / 2;
  faces.sd = max (abs (faces.difference) / 2, hypot (leftSd, rightSd) / 2);
  faces.width = -rightFoot(1) - leftFoot(1);
  faces.widthSd = hypot (leftFoot(2), rightFoot(2));
end

function [angle, sd, foot, depth] = faceOf (x, z, low)
  high = sort (z, 'descend');
  depth = median (high(1:ceil (numel (high) / 20))) - low;
  [angle, sd, foot] = flankLine (x, max (0, depth + low - z), depth);
end

%!test
%! % a bed of height 1 with faces of 50 and 40 deg down to a slot of 0.2
%! x = linspace (-3, 3, 900);
%! z = min (1, max (0, max ((abs (x) - 0.1) .* tand (50) .* (x < 0), ...
%!                          (abs (x) - 0.1) .* tand (40) .* (x > 0))));
%! faces = drawDownFaces (x, z);
%! assert ([faces.left, faces.right, faces.difference], [50, 40, 10], 0.1);
%! assert (faces.width, 0.2 + 1 / tand (50) + 1 / tand (40), 0.02);
%!assert (isnan (drawDownFaces (1:9, ones (1, 9)).angle))

% SPDX-License-Identifier: GPL-3.0-only
