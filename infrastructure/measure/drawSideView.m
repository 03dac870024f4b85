% DRAWSIDEVIEW  Draws grains from the side, with what was measured on them.
%
% CALL: drawSideView (FILE, GRAINS, POINTS, TEXT)
%
% FILE    picture to be written (SVG, text)
% GRAINS  n x 4, columns x y z radius (m), a frame of readDump
% POINTS  2 x m, the measured line, x and z (m), drawn on top of the grains; may
%         be empty
% TEXT    a line below the picture, for example 'angle 27.3 deg'
%
% The view is along y. Grains farther back are drawn first. The picture is as
% large as the grains and the line need.
%
% See also: surfaceLine, coneLine, readDump
function drawSideView (file, grains, points, text)
  line = reshape (points, 2, []).';
  grains = reshape (grains, [], 4);
  width = 640;
  [~, order] = sort (grains(:, 2), 'descend');
  grains = grains(order, :);
  low = min ([grains(:, [1, 3]) - grains(:, 4); line], [], 1);
  high = max ([grains(:, [1, 3]) + grains(:, 4); line], [], 1);
  if isempty (low)
    [low, high] = deal ([0, 0], [1, 1]);
  end
  scale = (width - 20) / max (high(1) - low(1), eps);
  height = scale * (high(2) - low(2)) + 60;
  px = @(v) 10 + (v - low(1)) * scale;
  py = @(v) 10 + (high(2) - v) * scale;
  circles = [px(grains(:, 1)), py(grains(:, 3)), scale * grains(:, 4)].';
  line = [px(line(:, 1)), py(line(:, 2))].';
  label = strrep (strrep (strrep (text, '&', '&amp;'), '<', '&lt;'), ...
                  '>', '&gt;');
  head = sprintf (['<svg xmlns="http://www.w3.org/2000/svg" ' ...
                   'viewBox="0 0 %d %.0f" role="img">\n' ...
                   '<title>%s</title>\n<rect width="100%%" ' ...
                   'height="100%%" fill="#ffffff"/>\n<g fill="#c9b27c" ' ...
                   'stroke="#6b5a2e" stroke-width="0.5">\n'], ...
                  width, height, label);
  body = sprintf ('<circle cx="%.1f" cy="%.1f" r="%.1f"/>\n', circles);
  outline = ['</g><polyline fill="none" stroke="#0b4f9e" stroke-width="3" ' ...
             'points="', sprintf('%.1f,%.1f ', line), '"/>'];
  foot = sprintf (['\n<text x="10" y="%.0f" font-family="sans-serif" ' ...
                   'font-size="18">%s</text>\n</svg>\n'], height - 14, label);
  writeAtomic (file, [head, body, outline, foot]);
end

%!test % a circle for each grain, the line, a text that is safe in XML
%! file = [tempname(), '.svg'];
%! grains = [0, 0, 0, 1; 2, 1, 0, 1; 1, 2, 1.7, 1];
%! drawSideView (file, grains, [-1, 0, 3; 0, 2, 1], 'a < b & c');
%! text = fileread (file);
%! assert (numel (strfind (text, '<circle')), 3);
%! points = regexp (text, 'points="([^"]*)"', 'tokens', 'once'){1};
%! at = sscanf (strrep (points, ',', ' '), '%f', [2, Inf]);
%! assert (columns (at), 3);
%! assert (at(1, [1, 3]), [10, 630], 0.1);
%! assert (~isempty (strfind (text, 'a &lt; b &amp; c')));
%!test % nothing to draw is a picture too
%! file = [tempname(), '.svg'];
%! drawSideView (file, [], [], 'no grains');
%! assert (~isempty (strfind (fileread (file), 'no grains')));

% SPDX-License-Identifier: GPL-3.0-only
