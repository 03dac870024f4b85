% GRAINPICTURE  Draws grains from the side as an SVG element.
%
% CALL: SVG = grainPicture (GRAINS, LINES, TITLE)
%
%   GRAINS  n x 4, columns x y z radius, see readDump
%   LINES   1 x k cell of m x 2 (x, z): dashed lines on top
%   TITLE   name of the picture (text)
%
% Of more than 3000 grains the nearest to the viewer are drawn. The free surface
% is that of silhouette.
%
% See also: sectionParticles, silhouette

function svg = grainPicture (grains, lines, title)
  [~, order] = sort (grains(:, 2), 'descend');
  grains = grains(order(max (1, end - 2999):end), :);
  low = min (grains(:, [1, 3]) - grains(:, 4), [], 1);
  high = max (grains(:, [1, 3]) + grains(:, 4), [], 1);
  for k = 1:numel (lines)
    low = min ([low; lines{k}], [], 1);
    high = max ([high; lines{k}], [], 1);
  end
  width = 340;
  scale = min ((width - 8) ./ (high(1) - low(1)), 260 / (high(2) - low(2)));
  height = ceil ((high(2) - low(2)) * scale) + 8;
  left = (width - (high(1) - low(1)) * scale) / 2;
  px = @(x) left + (x - low(1)) * scale;
  pz = @(z) height - 4 - (z - low(2)) * scale;
  M = [px(grains(:, 1)), pz(grains(:, 3)), grains(:, 4) * scale];
  circles = sprintf ('<circle cx="%.1f" cy="%.1f" r="%.1f"/>', M');
  x = linspace (low(1), high(1), 120);
  z = silhouette (grains, x);
  surface = pathOf (px (x), pz (z));
  dashed = '';
  for k = 1:numel (lines)
    dashed = [dashed, '<polyline fill="none" stroke="var(--ink)" ', ...
              'stroke-width="2" stroke-dasharray="7 5" points="', ...
              points(px (lines{k}(:, 1)'), pz (lines{k}(:, 2)')), '"/>'];
  end
  alt = sprintf ('%s: %d grains from the side, %.3g m wide, %.3g m high', ...
                 title, rows (grains), high - low);
  svg = sprintf (['<svg viewBox="0 0 %d %d" width="%d" height="%d" ', ...
                  'role="img" aria-label="%s"><title>%s</title>', ...
                  '<g fill="var(--midblue)" stroke="var(--blue)" ', ...
                  'stroke-width=".5">%s</g><path fill="none" ', ...
                  'stroke="var(--red)" stroke-width="2" d="%s"/>%s', ...
                  '</svg>'], width, height, width, height, htmlText (alt), ...
                 htmlText (title), circles, surface, dashed);
end

% A line that is broken where there is nothing.
function text = pathOf (x, y)
  text = '';
  pen = 'M';
  for k = 1:numel (x)
    if isfinite (y(k))
      text = [text, sprintf('%s%.1f %.1f', pen, x(k), y(k))];
      pen = 'L';
    else
      pen = 'M';
    end
  end
end

function text = points (x, y)
  text = strtrim (sprintf ('%.1f,%.1f ', [x(:), y(:)]'));
end

%!test
%! svg = grainPicture ([0, 0, 0, 1; 4, 1, 0, 1], {[0, 0; 1, 1]}, 'a & b');
%! assert (numel (strfind (svg, '<circle')), 2);
%! assert (! isempty (strfind (svg, 'a &amp; b: 2 grains')));
%! assert (isempty (strfind (svg, 'NaN')));
