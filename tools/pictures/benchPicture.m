% BENCHPICTURE  Draws grains as an SVG file, seen along y, panels side by side.
%
% CALL: benchPicture (FILE, PANELS, WALLS)
%
% FILE    text, name of the SVG file
% PANELS  1 x p cell of n x 4 matrices (x y z radius, m), as readDump gives
% WALLS   1 x p cell of m x 4 matrices (x1 z1 x2 z2, m), lines to draw
%
% The grains behind are drawn first and darker.
%
% See also: benchPictures, readDump
function benchPicture (file, panels, walls)
  scale = 2200;
  gap = 30;
  at = 10;
  body = '';
  tall = 0;
  for k = 1:numel (panels)
    [box, size1] = extent (panels{k}, walls{k});
    tall = max (tall, size1(2) * scale);
  end
  for k = 1:numel (panels)
    [box, size1] = extent (panels{k}, walls{k});
    toX = @(x) at + (x - box(1)) * scale;
    toY = @(z) 10 + tall - (z - box(2)) * scale;
    body = [body, circles(panels{k}, toX, toY, scale), ...
            lines(walls{k}, toX, toY)];
    at = at + size1(1) * scale + gap;
  end
  fid = fopen (file, 'w');
  fprintf (fid, ['<svg xmlns="http://www.w3.org/2000/svg" ' ...
                 'viewBox="0 0 %.0f %.0f" width="%.0f">\n'], ...
           at - gap + 10, tall + 20, min (at - gap + 10, 900));
  fprintf (fid, ['<rect width="100%%" height="100%%" fill="white"/>\n' ...
                 '<g stroke="#5b4a36" stroke-width="0.6">\n%s</g>\n' ...
                 '</svg>\n'], body);
  fclose (fid);
end

function [box, size1] = extent (grains, wall)
  low = min ([grains(:, [1, 3]) - grains(:, 4); wall(:, 1:2); wall(:, 3:4)]);
  high = max ([grains(:, [1, 3]) + grains(:, 4); wall(:, 1:2); wall(:, 3:4)]);
  box = [low, high];
  size1 = high - low;
end

function text = circles (grains, toX, toY, scale)
  [~, order] = sort (grains(:, 2), 'descend');
  grains = grains(order, :);
  depth = linspace (0.55, 1, rows (grains)).';
  colour = round (depth * [222, 184, 120]);
  text = sprintf (['<circle cx="%.1f" cy="%.1f" r="%.1f" ' ...
                   'fill="#%02x%02x%02x"/>\n'], ...
                  [toX(grains(:, 1)), toY(grains(:, 3)), ...
                   scale * grains(:, 4), colour].');
end

function text = lines (wall, toX, toY)
  text = sprintf (['<line x1="%.1f" y1="%.1f" x2="%.1f" y2="%.1f" ' ...
                   'stroke="#334" stroke-width="2"/>\n'], ...
                  [toX(wall(:, 1)), toY(wall(:, 2)), ...
                   toX(wall(:, 3)), toY(wall(:, 4))].');
end

%!test % one grain, one wall
%! file = [tempname(), '.svg'];
%! benchPicture (file, {[0, 0, 1, 0.5]}, {[0, 0, 1, 0]});
%! text = fileread (file);
%! delete (file);
%! assert (numel (strfind (text, '<circle')), 1);
%! assert (numel (strfind (text, '<line')), 1);

% SPDX-License-Identifier: GPL-3.0-only
