% HTMLFIGURES  Figures side by side, as many as the screen has room for.
%
% CALL: HTML = htmlFigures (FIGURES, KEY, CLASS)
%
%   FIGURES  1 x n struct array, see newFigure
%   KEY      entries of htmlKey, optional
%   CLASS    how wide: 'panels' (default), 'pairs', 'wide', 'one', 'corner' (each
%            at its place)
%   HTML     SVG elements with their captions, below the key
%
% One start of gnuplot draws all. Texts stay texts. The colours become
% variables of page.css, so that the figures follow the colours of the page; the
% symbols are defined once a page. A pointer that rests on a symbol or a bar sees
% its values.
%
% Errors: those of drawSvg

function html = htmlFigures (figures, key, class)
  html = '';
  if isempty (figures)
    return
  end
  if nargin < 3
    class = 'panels';
  end
  if nargin > 1 && ~isempty (key)
    html = htmlKey (key);
  end
  scroll = '';
  if strcmp (class, 'wide')
    scroll = ' role="region" tabindex="0" aria-label="Figure"';
  end
  svgs = drawn (figures);
  for k = 1:numel (figures)
    if figures(k).caption
      svgs{k} = ['<figcaption>', htmlText(figures(k).title), ...
                 '</figcaption>', svgs{k}];
    end
    place = '';
    if ~isempty (figures(k).place)
      place = sprintf (' style="grid-area:%d/%d"', figures(k).place);
    end
    svgs{k} = ['<figure', place, '>', svgs{k}, "</figure>\n"];
  end
  html = [html, '<div class="', class, '"', scroll, '>', svgs{:}, "</div>\n"];
end

function svgs = drawn (figures)
  script = {'set encoding utf8'};
  for k = 1:numel (figures)
    script = [script, figureLines(figures(k), sprintf ('%d.svg', k))];
  end
  svgs = cellfun (@cleanSvg, drawSvg (script, numel (figures)), ...
                  num2cell (figures), 'UniformOutput', false);
end

function lines = figureLines (f, file)
  data = cellfun (@(M) M(all (isfinite (M), 2), :), f.layers(:, 2), ...
                  'UniformOutput', false);
  isSeen = ~cellfun (@isempty, data);
  data = data(isSeen);
  colours = f.layers(isSeen, 3);
  kinds = cellfun (@(kind) layerKinds ().(kind), f.layers(isSeen, 1), ...
                   'UniformOutput', false);
  kinds = vertcat (cell (0, 3), kinds{:});
  valuesOf = @(which) cell2mat (cellfun (@(M, at) M(:, at)(:), data, ...
                                         kinds(:, which), ...
                                         'UniformOutput', false));
  plots = {'NaN notitle'};
  lines = {};
  for k = 1:numel (data)
    form = [strtrim(repmat ('%.6g ', 1, columns (data{k}))), '\n'];
    lines{k} = sprintf ("$D%d << EOD\n%sEOD", k, sprintf (form, data{k}'));
    plots{k} = sprintf ('$D%d with %s%s', k, kinds{k, 1}, ...
                        coloured (colours{k}));
  end
  lines = [{'reset', sprintf(['set terminal svg noenhanced size %d,%d ', ...
                              'font ''sans-serif,12'''], f.size), ...
            ['set output ''', file, ''''], ...
            ['set border 3 lc', coloured('axis')], ...
            ['set grid lc', coloured('grid'), ' lt 1 lw 1'], ...
            'set key off', 'set style fill solid 1 noborder', ...
            sprintf('set bmargin %g', 1.9 + 1.4 * ~isempty (f.xlabel)), ...
            'set tmargin 0.5', 'set rmargin 2.8', ...
            ['set xlabel ', quoted(f.xlabel, 40), ' offset 0,0.5'], ...
            ['set ylabel ', quoted(f.ylabel, 34), ' offset 0.8,0'], ...
            axisLines('x', extent (valuesOf (2), f.xlim), {}, f), ...
            axisLines('y', extent (valuesOf (3), f.ylim), f.ynames, f)}, ...
           lines, {['plot ', strjoin(plots, ', ')]}];
end

% How gnuplot draws each kind of layer; the columns that are x, and y.
function kinds = layerKinds ()
  kinds = struct ('area', {{'filledcurves fc', 1, 2:3}}, ...
                  'box', {{'boxxyerror fc', [1, 3, 4], [2, 5, 6]}}, ...
                  'line', {{'lines lw 2 lc', 1, 2}}, ...
                  'dash', {{'lines lw 1.5 dt (6,4) lc', 1, 2}}, ...
                  'dots', {{'points pt 7 ps 0.3 lc', 1, 2}}, ...
                  'disc', {{'points pt 7 ps 0.6 lc', 1, 2}}, ...
                  'ring', {{'points pt 6 ps 0.55 lc', 1, 2}}, ...
                  'diamond', {{'points pt 13 ps 1.1 lc', 1, 2}}, ...
                  'triangle', {{'points pt 9 ps 0.8 lc', 1, 2}}, ...
                  'xbar', {{'xerrorbars pt 7 ps 0.6 lw 1.5 lc', ...
                            [1, 3, 4], 2}}, ...
                  'ybar', {{'yerrorbars pt 7 ps 0.6 lw 1.5 lc', 1, 2:4}});
end

% From end to end what is asked for, else the data and a bit more.
function range = extent (values, asked)
  isFree = isnan (asked);
  range = [0, 1];
  if isempty (values) && any (isFree)
    return
  end
  ends = [min([values; NaN]), max([values; NaN])];
  range(isFree) = ends(isFree);
  range(~isFree) = asked(~isFree);
  pad = 0.04 * diff (range);
  if pad <= 0
    pad = max (abs (range(1)) * 0.05, 1e-12);
  end
  range = range + isFree .* [-pad, pad];
end

function text = axisLines (side, range, names, f)
  at = 1:numel (names);
  scale = 0;
  if isempty (names)
    isX = side == 'x';
    n = max (2, round (f.size(2 - isX) / (60 + 20 * isX)));
    ticks = {@niceTicks, @logTicks};
    at = ticks{1 + f.([side, 'log'])} (range, n);
    if isX && f.whole
      at = unique (round (at));
    end
    names = arrayfun (@(x) sprintf ('%.6g', x), at, 'UniformOutput', false);
    scale = 0.5;
  end
  % to gnuplot the name of a tic is a format of its place
  spots = cellfun (@(name, x) sprintf ('%s %.10g', ...
                                       strrep (quoted (name, 26), '%', ...
                                               '%%'), x), ...
                   names, num2cell (at), 'UniformOutput', false);
  text = sprintf (["set %srange [%.10g:%.10g]\n", ...
                   'set %stics nomirror scale %g (%s)'], side, range, side, ...
                  scale, strjoin (spots, ', '));
  text = [text, repmat(["\nset logscale ", side], 1, f.([side, 'log']))];
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

function text = quoted (text, most)
  text = text(:)';
  text(text < 32 | text == '`') = ' ';
  if numel (text) > most && all (text < 128)
    text = [text(1:most - 2), '..'];
  end
  text = ['''', strrep(text, '''', ''''''), ''''];
end

% One svg element without head, definitions, empty groups, names.
function svg = cleanSvg (text, f)
  body = regexp (text, '</defs>(.*)</svg>', 'tokens', 'once'){1};
  body = withHovers (body, f);
  body = regexprep (body, {'<title>(gnuplot_plot_|\$)[^<]*</title>', ' id="[^"]*"'}, '');
  body = regexprep (body, '\s*\n\s*', "\n");
  was = '';
  while ~strcmp (was, body)
    was = body;
    body = regexprep (body, '<g [^>]*>\s*</g>', '');
  end
  body = strrep (body, 'xlink:href', 'href');
  body = regexprep (body, {' stroke-line(cap|join)="\w+"', ...
                           ' class="gridline"'}, '');
  names = houseColours ();
  for k = 1:numel (names)
    body = regexprep (body, sprintf ('rgb\\( *1, *2, *%d\\)', k), ...
                      ['var(--', names{k}, ')']);
  end
  body = regexprep (body, '(fill|color|stroke)="black"', ...
                    '$1="var(--ink)"');
  body = strrep (body, 'color=''white''', 'color="var(--paper)"');
  % the last group closes the canvas, which was opened before the definitions
  body = regexprep (body, '</g>\s*$', '', 'once');
  svg = sprintf (['<svg viewBox="0 0 %d %d" width="%d" height="%d" ', ...
                  'role="img" aria-label="%s"><title>%s</title>%s</svg>'], ...
                 f.size, f.size, htmlText (f.alt), htmlText (f.title), ...
                 strtrim (body));
end

% The plots of gnuplot are named $D1, $D2 ..., the layers that have data; 60
% symbols at most get their values.
function body = withHovers (body, f)
  shapes = struct ('box', 'polygon', 'disc', 'use', 'diamond', 'use', 'triangle', 'use', ...
                   'ring', 'use', 'dots', 'use', 'xbar', 'use', 'ybar', 'use');
  parts = strsplit (body, '<g id="gnuplot_plot_');
  n = 0;
  for k = 1:rows (f.layers)
    M = f.layers{k, 2};
    M = M(all (isfinite (M), 2), :);
    n = n + ~isempty (M);
    at = find (~cellfun (@isempty, strfind (parts, sprintf ('<title>$D%d</title>', n))), 1);
    if isempty (M) || isempty (at) || ~isfield (shapes, f.layers{k, 1})
      continue
    end
    form = ['<', shapes.(f.layers{k, 1}), ' [^>]*/>'];
    [marks, between] = regexp (parts{at}, form, 'match', 'split');
    if numel (marks) ~= rows (M) || rows (M) > 60
      continue
    end
    for i = 1:rows (M)
      x = M(i, 1);
      if strcmp (f.layers{k, 1}, 'box')
        x = M(i, 3 + (M(i, 3) == 0 | isempty (f.ynames)));
      end
      marks{i} = sprintf ('%s><title>%s</title></%s>', marks{i}(1:end - 2), ...
                          htmlText (valueText (x, M(i, 2), f)), shapes.(f.layers{k, 1}));
    end
    pieces = [between; [marks, {''}]];
    parts{at} = [pieces{:}];
  end
  body = strjoin (parts, '<g id="gnuplot_plot_');
end

function text = valueText (x, y, f)
  text = sprintf ('%s %.4g', f.xlabel, x);
  if isempty (f.ynames)
    text = sprintf ('%s, %s %.4g', text, f.ylabel, y);
  elseif y == round (y) && y >= 1 && y <= numel (f.ynames)
    text = sprintf ('%s: %.4g', f.ynames{y}, x);
  end
  text = strtrim (text);
end

% Of gnuplot a colour is but a mark that stands for a variable of page.css.
function names = houseColours ()
  names = {'ink', 'axis', 'grid', 'blue', 'red', 'green', 'sky', 'amber', ...
           'grey', 'paleblue', 'midblue', 'palegreen', 'palegrey'};
end

function text = coloured (name)
  text = sprintf (' rgb ''#0102%02x''', find (strcmp (name, houseColours ())));
end

%!testif ; ! isempty (file_in_path (getenv ('PATH'), 'gnuplot'))
%! f = newFigure ('T<1>', 'mu ''x''', 'y `a`', 'a "line"', ...
%!                {'area', [0, 1, 2; 1, 2, 3; NaN, 1, 2], 'paleblue'; ...
%!                 'line', [0, 1; 1, 2], 'blue'; ...
%!                 'disc', [0, 1; 1, 2], 'red'; 'dots', [NaN, 1], 'ink'});
%! svg = strsplit (htmlFigures ([f, f]), '<figure>'){3};
%! assert (! isempty (strfind (svg, 'aria-label="a &quot;line&quot;"')));
%! assert (! isempty (strfind (svg, 'var(--paleblue)')));
%! assert (! isempty (strfind (svg, 'mu ''x''')));
%! assert (isempty (strfind (svg, 'rgb(')));
%! assert (! isempty (strfind (svg, '<title>mu ''x'' 1, y `a` 2</title>')));
%! opened = numel (regexp (svg, '<g[ >]'));
%! assert (numel (strfind (svg, '</g>')), opened);
%! % nothing in it: axes all the same
%! svg = htmlFigures (newFigure ('T', 'x', 'y', 'a'));
%! assert (! isempty (strfind (svg, '<text>')));
%! assert (htmlFigures ([]), '');
%! % a percent sign in the name of a tic
%! f.ynames = {'5 % of y', 'b'};
%! assert (! isempty (strfind (htmlFigures (f), '5 % of y')));
