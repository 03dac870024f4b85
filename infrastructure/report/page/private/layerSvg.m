% LAYERSVG  A layer of a figure as SVG elements.
%
% CALL: SHAPES = layerSvg (KIND, M, COLOUR, PX, PY [, HOVER])
%
%   KIND, M, COLOUR  see newFigure: rows of M are finite
%   PX, PY           handles: from the numbers of M to px
%   HOVER            n x 1 cell of texts that a pointer sees, a row of M each;
%                    default none. An area and a line have none
%   SHAPES           1 x m cell of elements

function shapes = layerSvg (kind, M, colour, px, py, hover)
  if nargin < 6
    hover = {};
  end
  paint = sprintf ('="var(--%s)"', colour);
  widths = struct ('line', '2', 'dash', '1.5" stroke-dasharray="6 4');
  switch kind
    case 'area'
      shapes = {polygon([px(M(:, 1)); flipud(px (M(:, 1)))], ...
                        [py(M(:, 2)); flipud(py (M(:, 3)))], paint)};
    case 'box'
      shapes = arrayfun (@(i) polygon (px (M(i, [3, 4, 4, 3])), ...
                                       py (M(i, [5, 5, 6, 6])), paint), ...
                         1:rows (M), 'UniformOutput', false);
    case fieldnames (widths)
      shapes = {['<path fill="none" stroke', paint, ' stroke-width="', widths.(kind), ...
                 '" d="', svgPath(px (M(:, 1)), py (M(:, 2))), '"/>']};
    otherwise
      shapes = symbols (kind, M, paint, px, py);
  end
  if rows (M) == numel (hover)
    titles = strcat ('><title>', htmlText (hover(:)'), '</title>');
    % the last element of each shape is closed behind its title
    ends = struct ('box', '</polygon>');
    shapes = strcat (cellfun (@(s) s(1:end - 2), shapes, 'UniformOutput', false), ...
                     titles, givenField (ends, kind, '</use>'));
  end
end

function text = polygon (x, y, paint)
  text = ['<polygon fill', paint, ' points="', ...
          strtrim(sprintf ('%.1f,%.1f ', [x(:), y(:)]')), '"/>'];
end

% A bar lies below its symbol.
function shapes = symbols (kind, M, paint, px, py)
  known = struct ('dots', {{'disc', 1.4}}, 'disc', {{'disc', 2.7}}, ...
                  'ring', {{'ring', 2.5}}, 'diamond', {{'diamond', 5}}, ...
                  'triangle', {{'triangle', 3.6}}, 'xbar', {{'disc', 2.7}}, ...
                  'ybar', {{'disc', 2.7}});
  [x, y] = deal (px (M(:, 1)), py (M(:, 2)));
  shapes = arrayfun (@(x, y) sprintf (['<use href="#p-%s" color%s ', ...
                                       'transform="translate(%.1f,%.1f) scale(%g)"/>'], ...
                                      known.(kind){1}, paint, x, y, known.(kind){2}), ...
                     x', y', 'UniformOutput', false);
  form = '<path stroke-width="1.5" stroke%s d="M%.1f %.1fL%.1f %.1f"/>%s';
  for k = 1:numel (shapes) * strcmp (kind, 'xbar')
    shapes{k} = sprintf (form, paint, px (M(k, 3)), y(k), px (M(k, 4)), y(k), shapes{k});
  end
  for k = 1:numel (shapes) * strcmp (kind, 'ybar')
    shapes{k} = sprintf (form, paint, x(k), py (M(k, 3)), x(k), py (M(k, 4)), shapes{k});
  end
end

%!test
%! same = @(x) x;
%! assert (layerSvg ('line', [0, 1; 2, 3], 'ink', same, same), ...
%!         {['<path fill="none" stroke="var(--ink)" stroke-width="2" ', ...
%!           'd="M0.0 1.0L2.0 3.0"/>']});
%! s = layerSvg ('xbar', [1, 2, 0, 3; 1, 3, 0, 3], 'blue', same, same, {'a', 'b'});
%! assert (numel (s), 2);
%! assert (! isempty (regexp (s{2}, '^<path.*<use [^>]*><title>b</title></use>$')));
%! assert (numel (layerSvg ('box', [0, 0, 1, 2, 3, 4], 'red', same, same)), 1);
%! assert (layerSvg ('dots', zeros (0, 2), 'red', same, same), cell (1, 0));

% SPDX-License-Identifier: GPL-3.0-only
