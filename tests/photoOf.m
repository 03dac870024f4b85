% PHOTOOF  A picture of grains from the side, as a camera sees them.
%
% CALL: photoOf (FILE, GRAINS, SCALE, HOW)
%
%   FILE    png that is written (path)
%   GRAINS  n x 4, columns x y z radius (m), a frame of readDump; the base is z = 0
%   SCALE   m a pixel
%   HOW     scalar struct: roll (deg, of the camera), noise (grey levels, standard
%           deviation of each pixel), light (grey levels by which the background gets
%           darker from left to right), each 0 where it is not given
%
% Grains have shades of their own, the nearest covers the others.

function photoOf (file, grains, scale, how)
  roll = givenField (how, 'roll', 0);
  turn = [cosd(roll), -sind(roll); sind(roll), cosd(roll)];
  grains(:, [1, 3]) = grains(:, [1, 3]) * turn';
  margin = 0.15 * (max (grains(:, 1)) - min (grains(:, 1)));
  left = min (grains(:, 1)) - margin;
  high = max (grains(:, 3)) + margin;
  n = ceil ((max (grains(:, 1)) + margin - left) / scale);
  m = ceil ((high + max (0, -min (grains(:, 3))) + 2 * scale) / scale);
  picture = repmat (225 - givenField (how, 'light', 0) * (0:n - 1) / n, m, 1);
  [~, order] = sort (grains(:, 2), 'descend');
  for g = grains(order, :)'
    i = max (1, ceil ((high - g(3) - g(4)) / scale)):min (m, ceil ((high - g(3) + g(4)) / scale));
    j = max (1, ceil ((g(1) - g(4) - left) / scale)):min (n, ceil ((g(1) + g(4) - left) / scale));
    [X, Z] = meshgrid (left + (j - 0.5) * scale, high - (i - 0.5) * scale);
    isIn = (X - g(1)).^2 + (Z - g(3)).^2 < g(4)^2;
    part = picture(i, j);
    part(isIn) = 60 + 60 * rem (abs (1e4 * g(1)), 1) + 20 * (Z(isIn) - g(3)) / g(4);
    picture(i, j) = part;
  end
  noise = givenField (how, 'noise', 0);
  imwrite (uint8 (picture + noise * randn (m, n)), file);
end

% SPDX-License-Identifier: GPL-3.0-only
