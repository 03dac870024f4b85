% PICTUREOUTLINE  Surface of a heap in a picture of it from the side.
%
% CALL: [X, Z] = pictureOutline (FILE)
%
%   FILE  picture (png, jpg, tif, bmp) of a heap on a level plate, its whole
%         width and some background on both sides and above in view, the grains
%         of another colour than the background (path)
%   X, Z  1 x n, place along the base (rising) and height of the surface above it
%         there (pixels of the picture)
%
% The background is the median colour of the uppermost twentieth of the picture;
% what is further away from it than the threshold of Otsu (1979), which parts the
% distances into two groups best, is heap. The surface is the upper end of what
% is joined to the bottom in its column. The base runs between what is seen at
% both margins (a plate), else along the lowest row of the heap. Pictures of more
% than 1,500 columns are averaged down.
%
% Errors: DEcalioc:pictureOutline:badValue (no picture that Octave reads, or
% nothing stands out in it)

function [x, z] = pictureOutline (file)
  picture = readPicture (file);
  factor = ceil (columns (picture) / 1500);
  picture = averaged (picture, factor);
  m = rows (picture);
  n = columns (picture);
  sky = reshape (picture(1:max (2, ceil (m / 20)), :, :), [], size (picture, 3));
  sky = reshape (median (sky, 1), 1, 1, []);
  far = sqrt (sum ((picture - sky).^2, 3));
  isHeap = conv2 (double (far > threshold (far)), ones (3) / 9, 'same') > 0.5;
  if ~any (isHeap(:))
    refuse (file, 0);
  end
  top = NaN (1, n);
  for k = 1:n
    top(k) = upperEnd (find (isHeap(:, k)), m / 50);
  end
  base = baseLine (top, isHeap);
  z = base - top;
  z(isnan (z)) = 0;
  % along the base and at right angles to it: the camera may be rolled
  roll = -atan2 (base(n) - base(1), n - 1);
  x = ((1:n) - 0.5) / cos (roll) + z * sin (roll);
  [x, order] = sort (x * factor);
  z = max (z(order), 0) * cos (roll) * factor;
  share = mean (z > 0.02 * m * factor);
  if share < 0.1
    refuse (file, share);
  end
end

function refuse (file, share)
  error ('DEcalioc:pictureOutline:badValue', ...
         ['pictureOutline: %s must show a heap of another colour than the ' ...
          'background, got %.0f %% of its columns in which something stands ' ...
          'out. Cut the picture, or put a plain sheet behind the heap.'], ...
         file, 100 * share);
end

function picture = readPicture (file)
  try
    [picture, map] = imread (file);
  catch err
    error ('DEcalioc:pictureOutline:badValue', ...
           ['pictureOutline: %s must be a picture that this Octave reads, got: ' ...
            '%s. Save it as PNG.'], file, err.message);
  end
  top = 1;
  if isinteger (picture)
    top = double (intmax (class (picture)));
  end
  if ~isempty (map)
    picture = ind2rgb (picture, map);
    top = 1;
  end
  picture = double (picture(:, :, 1:min (end, 3))) / top;
  if size (picture, 3) == 2                           % grey and alpha
    picture = picture(:, :, 1);
  end
end

function small = averaged (picture, factor)
  small = picture;
  if factor > 1
    m = floor ([rows(picture), columns(picture)] / factor);
    p = size (picture, 3);
    small = picture(1:m(1) * factor, 1:m(2) * factor, :);
    small = reshape (small, factor, m(1), factor, m(2), p);
    small = reshape (mean (mean (small, 1), 3), m(1), m(2), p);
  end
end

% Otsu: where the variance between the two groups is largest.
function t = threshold (values)
  edges = linspace (0, max (values(:)) + eps, 257);
  count = histc (values(:)', edges)(1:256);
  p = count / sum (count);
  middle = (edges(1:256) + edges(2:257)) / 2;
  below = cumsum (p);
  mass = cumsum (p .* middle);
  between = (mass(end) * below - mass).^2 ./ max (below .* (1 - below), eps);
  [~, k] = max (between);
  t = edges(k + 1);
end

% Of the rows of a column that are heap the first one that is joined to the last,
% over gaps of up to MOST rows.
function row = upperEnd (rowsOf, most)
  row = NaN;
  if ~isempty (rowsOf)
    k = find (diff (rowsOf) > most, 1, 'last');
    row = rowsOf(1 + max ([0; k(:)])) - 0.5;
  end
end

function base = baseLine (top, isHeap)
  n = numel (top);
  margin = max (3, round (n / 33));
  ends = {1:margin, n - margin + 1:n};
  isSeen = cellfun (@(k) mean (~isnan (top(k))) > 0.5, ends);
  if all (isSeen)
    level = cellfun (@(k) median (top(k)(~isnan (top(k)))), ends);
    place = cellfun (@mean, ends);
    base = interp1 (place, level, 1:n, 'linear', 'extrap');
  else
    base = repmat (find (any (isHeap, 2), 1, 'last') + 0.5, 1, n);
  end
end

%!function file = drawn (angle, roll, plate, noise, colours, ending)
%!  % 600 x 300 pixels, a heap of 110 pixels on a plate or on nothing
%!  [X, Y] = meshgrid ((1:600) - 300, 270 - (1:300));
%!  c = cosd (roll);
%!  s = sind (roll);
%!  [X, Y] = deal (c * X + s * Y, c * Y - s * X);
%!  isIn = Y < 110 - abs (X) * tand (angle) & Y > 0;
%!  isIn |= plate & Y <= 0;
%!  picture = zeros (300, 600, 3);
%!  for k = 1:3
%!    layer = colours(1, k) + (colours(2, k) - colours(1, k)) * isIn;
%!    picture(:, :, k) = conv2 (layer, ones (3) / 9, 'same');
%!    picture([1, end], :, k) = layer([1, end], :);
%!    picture(:, [1, end], k) = layer(:, [1, end]);
%!  end
%!  picture += noise * randn (size (picture)) + 0.05 * (X + 300) / 600;
%!  file = [tempname(), ending];
%!  imwrite (uint8 (255 * min (max (picture, 0), 1)), file);
%!endfunction
%!test
%! % dark on light, light on dark, colour alone; with and without a plate; png, jpg;
%! % the camera rolled by 2 deg over a plate: within 0.3 deg of the angle
%! state = randn ('state');
%! randn ('state', 5);
%! dark = [0.9, 0.9, 0.9; 0.3, 0.25, 0.2];
%! red = [0.4, 0.5, 0.4; 0.7, 0.3, 0.3];
%! for row = {25, 0, true, 0.03, dark, '.png'; 35, 0, false, 0.03, dark, '.png'; ...
%!            30, 0, true, 0.03, flipud(dark), '.jpg'; 30, 2, true, 0.02, dark, ...
%!            '.png'; 28, 0, false, 0.02, red, '.png'}'
%!   file = drawn (row{:});
%!   [x, z] = pictureOutline (file);
%!   unlink (file);
%!   heap = flankAngles (x, z);
%!   assert (heap.angle, row{1}, 0.3);
%!   assert (heap.radius, 110 / tand (row{1}), 0.02 * heap.radius);
%!   assert (heap.sd < 0.3);
%! end
%! randn ('state', state);
%!test
%! % a large picture is averaged, a speck above the heap does not count
%! picture = uint8 (255 * ones (800, 3200));
%! [X, Y] = meshgrid ((1:3200) - 1600, 760 - (1:800));
%! picture(Y < 600 - abs (X) * tand (27) & Y > 0) = 60;
%! picture(20:60, 1000:1040) = 60;
%! file = [tempname(), '.png'];
%! imwrite (picture, file);
%! [x, z] = pictureOutline (file);
%! unlink (file);
%! assert (numel (x), 1066);
%! assert (max (z), 600, 6);
%! assert (flankAngles (x, z).angle, 27, 0.2);
%!error <Save it as PNG> pictureOutline ('/no/such/picture.png')
%!error <stands out>
%! file = [tempname(), '.png'];
%! imwrite (uint8 (200 * ones (50, 80)), file);
%! pictureOutline (file);

% SPDX-License-Identifier: GPL-3.0-only
