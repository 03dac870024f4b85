% FIGURESVG  A figure as an SVG element.
%
% CALL: SVG = figureSvg (F)
%
%   F    see newFigure
%   SVG  text. Texts stay texts, colours are variables of page.css, so that the
%        figure follows the colours of the page; symbols are those that writePage
%        defines once. A pointer that rests on one of up to 60 symbols or boxes of a
%        layer sees its values

function svg = figureSvg (f)
  layers = f.layers;
  layers(:, 2) = cellfun (@(M) M(all (isfinite (M), 2), :), layers(:, 2), ...
                          'UniformOutput', false);
  layers = layers(~cellfun (@isempty, layers(:, 2)), :);
  x = axisOf (valuesOf (layers, 1), f.xlim, f.xlog, {}, f.size(1) / 80, f.whole);
  y = axisOf (valuesOf (layers, 2), f.ylim, f.ylog, f.ynames, f.size(2) / 60, false);
  left = 14 + 6.9 * max ([cellfun(@numel, y.names), 1]) + 18 * ~isempty (f.ylabel);
  x.ends = [left, f.size(1) - 20];
  y.ends = [f.size(2) - 24 - 18 * ~isempty(f.xlabel), 8];
  body = cellfun (@(kind, M, colour) strjoin (layerSvg (kind, inside (kind, M, x, y), ...
                                                        colour, @(v) place (v, x), ...
                                                        @(v) place (v, y), ...
                                                        hovers(kind, M, f)), ''), ...
                  layers(:, 1), layers(:, 2), layers(:, 3), 'UniformOutput', false);
  svg = [sprintf(['<svg viewBox="0 0 %d %d" width="%d" height="%d" role="img" ', ...
                  'aria-label="%s"><title>%s</title>'], f.size, f.size, htmlText (f.alt), ...
                 htmlText (f.title)), frame(f, x, y), body{:}, '</svg>'];
end

% All that lies along an axis, x (1) or y (2), in a column.
function values = valuesOf (layers, which)
  columns_ = struct ('area', {{1, 2:3}}, 'box', {{[1, 3, 4], [2, 5, 6]}}, ...
                     'xbar', {{[1, 3, 4], 2}}, 'ybar', {{1, 2:4}});
  values = [];
  for layer = layers'
    at = givenField (columns_, layer{1}, {1, 2});
    values = [values; layer{2}(:, at{which})(:)];
  end
end

% From end to end what is asked for, else the data and a bit more.
function a = axisOf (values, asked, isLog, names, n, isWhole)
  ends = [min(values), max(values), zeros(1, isempty (values)), ones(1, isempty (values))];
  isFree = isnan (asked);
  asked(isFree) = ends(isFree);
  pad = 0.04 * diff (asked);
  if pad <= 0
    pad = max (abs (asked(1)) * 0.05, 1e-12);
  end
  a = struct ('range', asked + isFree .* [-pad, pad], 'isLog', isLog, 'at', ...
              1:numel (names), 'names', {cellfun(@(t) short (t, 26), names, ...
                                                 'UniformOutput', false)});
  if isempty (names)
    n = max (2, round (n));
    if isLog
      a.at = logTicks (a.range, n);
    else
      a.at = niceTicks (a.range, n);
    end
    if isWhole
      a.at = unique (round (a.at));
    end
    a.names = arrayfun (@(v) sprintf ('%.6g', v), a.at, 'UniformOutput', false);
  end
end

% Powers of ten inside RANGE, at most about N; below two of them 1, 2 and 5.
function at = logTicks (range, n)
  ends = log10 (range) + 1e-9 * [-1, 1];
  powers = ceil (ends(1)):floor (ends(2));
  at = 10.^powers(1:ceil (numel (powers) / n):end);
  if numel (powers) < 3
    at = [1; 2; 5] * 10.^(floor (ends(1)):floor (ends(2)));
    at = at(log10 (at) >= ends(1) & log10 (at) <= ends(2))(:)';
  end
end

% Multiples of 1, 2 or 5 times a power of ten inside RANGE, about N.
function at = niceTicks (range, n)
  raw = diff (range) / n;
  power = 10^floor (log10 (raw));
  steps = [1, 2, 5, 10];
  step = power * steps(find (steps * power >= 0.7 * raw, 1));
  at = step * (ceil (range(1) / step - 1e-9):floor (range(2) / step + 1e-9));
  at(abs (at) < step * 1e-6) = 0;
end

% From numbers to px; what is drawn ends at the frame.
function p = place (v, a)
  range = a.range;
  if a.isLog
    [v, range] = deal (log (max (v, realmin)), log (range));
  end
  share = min (max ((v - range(1)) / diff (range), 0), 1);
  p = a.ends(1) + share * diff (a.ends);
end

% Symbols outside of the frame are left out.
function M = inside (kind, M, x, y)
  if ~any (strcmp (kind, {'area', 'box', 'line', 'dash'}))
    is = @(v, a) v >= a.range(1) & v <= a.range(2);
    M = M(is (M(:, 1), x) & is (M(:, 2), y), :);
  end
end

function texts = hovers (kind, M, f)
  texts = {};
  if rows (M) > 60 || any (strcmp (kind, {'area', 'line', 'dash'}))
    return
  end
  v = M(:, 1);
  if strcmp (kind, 'box')               % the end that is not at zero
    isLow = M(:, 3) ~= 0 & ~isempty (f.ynames);
    v = M(:, 4) .* ~isLow + M(:, 3) .* isLow;
  end
  for i = 1:rows (M)
    texts{i} = strtrim (sprintf ('%s %.4g', f.xlabel, v(i)));
    y = M(i, 2);
    if isempty (f.ynames)
      texts{i} = strtrim (sprintf ('%s, %s %.4g', texts{i}, f.ylabel, y));
    elseif any (y == 1:numel (f.ynames))
      texts{i} = sprintf ('%s: %.4g', f.ynames{y}, v(i));
    end
  end
end

% Grid, axes, their numbers or names, what they mean.
function svg = frame (f, x, y)
  [px, py] = deal (place (x.at, x), place (y.at, y));
  lines = [sprintf('M%.1f %.1fV%.1f', [px; repmat(y.ends(:), 1, numel (px))]), ...
           sprintf('M%.1f %.1fH%.1f', [repmat(x.ends(1), 1, numel (py)); py; ...
                                       repmat(x.ends(2), 1, numel (py))])];
  svg = sprintf (['<path stroke="var(--grid)" d="%s"/><path fill="none" ', ...
                  'stroke="var(--axis)" d="M%.1f %.1fV%.1fH%.1f"/><g fill="var(--axis)" ', ...
                  'font-family="sans-serif" font-size="12">'], lines, x.ends(1), ...
                 y.ends([2, 1]), x.ends(2));
  label = @(form, px, py, text) sprintf (form, px, py, htmlText (text));
  tics = [cellfun(@(p, t) label ('<text x="%.1f" y="%.1f" text-anchor="middle">%s</text>', ...
                                 p, y.ends(1) + 16, t), num2cell (px), x.names, ...
                  'UniformOutput', false), ...
          cellfun(@(p, t) label ('<text x="%.1f" y="%.1f" text-anchor="end">%s</text>', ...
                                 x.ends(1) - 6, p + 4, t), num2cell (py), y.names, ...
                  'UniformOutput', false)];
  below = short (f.xlabel, floor (f.size(1) / 6.9));
  half = 3.4 * numel (below);
  middle = max (min (mean (x.ends), f.size(1) - half), half);
  svg = [svg, tics{:}, '</g><g fill="var(--ink)" font-family="sans-serif" font-size="12" ', ...
         'text-anchor="middle">', ...
         label('<text x="%.1f" y="%.1f">%s</text>', middle, f.size(2) - 6, below), ...
         label('<text transform="translate(%.1f,%.1f) rotate(-90)">%s</text>', 13, ...
               mean (y.ends), short (f.ylabel, 34)), '</g>'];
end

function text = short (text, most)
  if numel (text) > most && all (text < 128)
    text = [text(1:most - 2), '..'];
  end
end

%!test
%! f = newFigure ('T<1>', 'mu ''x''', 'y `a`', 'a "line"', ...
%!                {'area', [0, 1, 2; 1, 2, 3; NaN, 1, 2], 'paleblue'; ...
%!                 'line', [0, 1; 1, 2], 'blue'; ...
%!                 'disc', [0, 1; 1, 2], 'red'; 'dots', [NaN, 1], 'ink'});
%! svg = figureSvg (f);
%! assert (! isempty (strfind (svg, 'aria-label="a &quot;line&quot;"')));
%! assert (! isempty (strfind (svg, 'var(--paleblue)')));
%! assert (! isempty (strfind (svg, '<title>mu ''x'' 1, y `a` 2</title>')));
%! % each element has its end
%! marks = regexp (svg, '<(/?)\w+[^>]*?(/?)>', 'tokens');
%! isEnd = cellfun (@(m) ~isempty (m{1}), marks);
%! isWhole = cellfun (@(m) ~isempty (m{end}) && ~isempty (strfind (m{end}, '/')), marks);
%! assert (sum (isEnd), sum (~isEnd & ~isWhole));
%! % from 0 to 1 and a bit more; the first point at the left, one beyond is not drawn
%! x = str2double (regexp (svg, 'translate\(([\d.]+),[\d.]+\) scale', 'tokens'){1});
%! assert (x > 40 && x < 70);
%! f.xlim = [0.5, 2];
%! assert (numel (strfind (figureSvg (f), '<use')), 1);
%! % nothing in it: axes all the same
%! assert (! isempty (strfind (figureSvg (newFigure ('T', 'x', 'y', 'a')), '>0.6</text>')));
%! % names of rows; of a bar the end that is not zero
%! f = newFigure ('T', 'x', {'5 % of y', 'b'}, 'a', {'box', [0, 1, -3, 0, 0.8, 1.2], 'blue'});
%! svg = figureSvg (f);
%! assert (! isempty (strfind (svg, '>5 % of y</text>')));
%! assert (! isempty (strfind (svg, '<title>b: -3</title>')));
%!test
%! % a logarithmic axis has powers of ten
%! f = newFigure ('T', 'x', 'y', 'a', {'disc', [1e-3, 1; 10, 2], 'red'});
%! [f.xlog, f.xlim] = deal (true, [1e-3, 10]);
%! assert (! isempty (strfind (figureSvg (f), '>0.1</text>')));

% SPDX-License-Identifier: GPL-3.0-only
