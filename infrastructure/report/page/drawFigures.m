% DRAWFIGURES  Draws figures as SVG in the one style of the house.
%
% CALL: SVGS = drawFigures (FIGURES)
%
%   FIGURES  1 x n struct array, see newFigure
%   SVGS     1 x n cell of SVG elements for an HTML page
%
% One start of gnuplot draws all. Texts stay texts. The colours become
% variables of page.css, so that the figures follow the colours of the page; the
% symbols are defined once a page.
%
% Errors: DEcalioc:drawFigures:runFailed

function svgs = drawFigures (figures)
  folder = tempname ();
  mkdir (folder);
  tidy = onCleanup (@() removeFolder (folder));
  script = {'set encoding utf8'};
  files = cell (1, numel (figures));
  for k = 1:numel (figures)
    files{k} = fullfile (folder, sprintf ('%d.svg', k));
    script = [script, figureLines(figures(k), files{k})];
  end
  program = fullfile (folder, 'all.gp');
  writeAtomic (program, [strjoin(script, "\n"), "\nunset output\n"]);
  [status, text] = system (['gnuplot ', shellQuote(program), ...
                            ' 2>&1 < /dev/null']);
  if status ~= 0
    error ('DEcalioc:drawFigures:runFailed', ...
           ['drawFigures: gnuplot must draw the figures, got: %s. On ', ...
            'Debian: apt-get install gnuplot-nox.'], strtrim (text));
  end
  svgs = cell (1, numel (figures));
  for k = 1:numel (figures)
    svgs{k} = cleanSvg (fileread (files{k}), figures(k));
  end
end

function removeFolder (folder)
  confirm_recursive_rmdir (false, 'local');
  rmdir (folder, 's');
end

function lines = figureLines (f, file)
  c = houseColours ();
  lines = {'reset', ...
           sprintf(['set terminal svg noenhanced size %d,%d ', ...
                    'font ''sans-serif,12'''], f.size), ...
           ['set output ''', strrep(file, '''', ''''''), ''''], ...
           ['set border 3 lc rgb ''', c.axis, ''''], ...
           ['set grid lc rgb ''', c.grid, ''' lt 1 lw 1'], ...
           'set key off', 'set style fill solid 1 noborder', ...
           ['set bmargin ', sprintf('%g', 1.9 + 1.4 * ~isempty (f.xlabel))], ...
           'set tmargin 0.5', 'set rmargin 2.8', ...
           ['set xlabel ', quoted(f.xlabel, 40), ' offset 0,0.5'], ...
           ['set ylabel ', quoted(f.ylabel, 34), ' offset 0.8,0']};
  if f.xlog
    lines{end + 1} = 'set logscale x';
  end
  if f.equal
    lines{end + 1} = 'set size ratio -1';
  end
  [x, y] = extent (f);
  lines = [lines, axisLines('x', x, f.xnames, f), ...
           axisLines('y', y, f.ynames, f), layerLines(f, c)];
end

% Ranges of both axes: those asked for, else those of the data and a bit more.
function [x, y] = extent (f)
  x = f.xlim;
  y = f.ylim;
  spread = struct ('area', {{1, 2:3}}, 'box', {{[1, 3, 4], [2, 5, 6]}}, ...
                   'xbar', {{[1, 3, 4], 2}}, 'ybar', {{1, 2:4}});
  for layer = f.layers
    at = {1, 2};
    if isfield (spread, layer.kind)
      at = spread.(layer.kind);
    end
    xs = layer.data(:, at{1})(:);
    ys = layer.data(:, at{2})(:);
    x = wider (x, xs, f.xlim);
    y = wider (y, ys, f.ylim);
  end
  x = padded (x, f.xlim, f.xlog);
  y = padded (y, f.ylim, false);
end

function range = wider (range, values, asked)
  free = isnan (asked);
  both = [min([range(1), values']), max([range(2), values'])];
  range(free) = both(free);
end

function range = padded (range, asked, isLog)
  if any (isnan (range))
    range = [0, 1];
  elseif isLog
    range = range .* [0.7, 1.4].^isnan (asked);
  else
    pad = 0.04 * diff (range);
    if pad <= 0
      pad = max (abs (range(1)) * 0.05, 1e-12);
    end
    range = range + isnan (asked) .* [-pad, pad];
  end
end

function lines = axisLines (name, range, names, f)
  lines = {sprintf('set %srange [%.10g:%.10g]', name, range)};
  if ~isempty (names)
    spots = cell (1, numel (names));
    for k = 1:numel (names)
      spots{k} = sprintf ('%s %d', quoted (names{k}, 26), k);
    end
    lines{end + 1} = sprintf ('set %stics nomirror scale 0 (%s)', name, ...
                              strjoin (spots, ', '));
  elseif name == 'x' && f.xlog
    lines{end + 1} = 'set xtics nomirror scale 0.5';
  else
    px = f.size(1 + (name == 'y'));
    at = niceTicks (range, max (2, round (px / (60 + 20 * (name == 'x')))));
    if name == 'x' && f.whole
      at = unique (round (at));
    end
    spots = arrayfun (@(v) sprintf ('''%.6g'' %.10g', v, v), at, ...
                      'UniformOutput', false);
    lines{end + 1} = sprintf ('set %stics nomirror scale 0.5 (%s)', name, ...
                              strjoin (spots, ', '));
  end
end

function text = quoted (text, most)
  text = text(:)';
  text(text < 32 | text == '`') = ' ';
  if numel (text) > most && all (text < 128)
    text = [text(1:most - 2), '..'];
  end
  text = ['''', strrep(text, '''', ''''''), ''''];
end

function lines = layerLines (f, c)
  styles = houseStyles ();
  lines = {};
  parts = {};
  for k = 1:numel (f.layers)
    layer = f.layers(k);
    form = [strtrim(repmat ('%.6g ', 1, columns (layer.data))), '\n'];
    lines{end + 1} = sprintf ("$D%d << EOD\n%sEOD", k, ...
                              sprintf (form, layer.data'));
    parts{end + 1} = sprintf ('$D%d with %s', k, ...
                              strrep (styles.(layer.kind), 'COLOUR', ...
                                      c.(layer.colour)));
  end
  if isempty (parts)
    parts = {'NaN notitle'};
  end
  lines{end + 1} = ['plot ', strjoin(parts, ', ')];
end

% Multiples of 1, 2 or 5 times a power of ten inside RANGE, about N.
function at = niceTicks (range, n)
  raw = diff (range) / max (n, 1);
  power = 10^floor (log10 (raw));
  steps = [1, 2, 5, 10];
  step = power * steps(find (steps * power >= 0.7 * raw, 1));
  at = step * (ceil (range(1) / step - 1e-9):floor (range(2) / step + 1e-9));
  at(abs (at) < step * 1e-6) = 0;
end

% How gnuplot draws each kind of layer; COLOUR stands for the colour.
function s = houseStyles ()
  s = struct ('area', 'filledcurves fc rgb ''COLOUR''', ...
              'box', 'boxxyerror fc rgb ''COLOUR''', ...
              'line', 'lines lw 2 lc rgb ''COLOUR''', ...
              'dash', 'lines lw 1.5 dt (6,4) lc rgb ''COLOUR''', ...
              'dots', 'points pt 7 ps 0.3 lc rgb ''COLOUR''', ...
              'disc', 'points pt 7 ps 0.6 lc rgb ''COLOUR''', ...
              'ring', 'points pt 6 ps 0.55 lc rgb ''COLOUR''', ...
              'diamond', 'points pt 13 ps 1.1 lc rgb ''COLOUR''', ...
              'cross', 'points pt 2 ps 0.8 lw 1.5 lc rgb ''COLOUR''', ...
              'square', 'points pt 5 ps 0.6 lc rgb ''COLOUR''', ...
              'triangle', 'points pt 9 ps 0.8 lc rgb ''COLOUR''');
  s.xbar = 'xerrorbars pt 7 ps 0.6 lw 1.5 lc rgb ''COLOUR''';
  s.ybar = 'yerrorbars pt 7 ps 0.6 lw 1.5 lc rgb ''COLOUR''';
end

% One svg element without head, definitions, empty groups, names.
function svg = cleanSvg (text, f)
  body = regexp (text, '</defs>(.*)</svg>', 'tokens', 'once'){1};
  body = regexprep (body, '<title>[^<]*</title>', '');
  body = regexprep (body, ' id="[^"]*"', '');
  body = regexprep (body, '\s*\n\s*', "\n");
  was = '';
  while ~strcmp (was, body)
    was = body;
    body = regexprep (body, '<g [^>]*>\s*</g>', '');
  end
  body = strrep (body, 'xlink:href', 'href');
  body = regexprep (body, ' stroke-line(cap|join)="\w+"', '');
  body = regexprep (body, ' class="gridline"', '');
  body = withVariables (body);
  % the last group closes the canvas, which was opened before the definitions
  body = regexprep (body, '</g>\s*$', '', 'once');
  svg = sprintf (['<svg viewBox="0 0 %d %d" width="%d" height="%d" ', ...
                  'role="img" aria-label="%s"><title>%s</title>%s</svg>'], ...
                 f.size, f.size, htmlText (f.alt), htmlText (f.title), ...
                 strtrim (body));
end

function body = withVariables (body)
  colours = houseColours ();
  for name = fieldnames (colours)'
    rgb = sscanf (colours.(name{1}), '#%2x%2x%2x');
    form = sprintf ('rgb\\( *%d, *%d, *%d\\)', rgb);
    body = regexprep (body, form, sprintf ('var(--%s)', name{1}));
  end
  body = regexprep (body, '(fill|color|stroke)="black"', ...
                    '$1="var(--ink)"');
  body = strrep (body, 'color=''white''', 'color="var(--paper)"');
end

% The colours of all figures, safe for the colour-blind (the strong ones those
% of Okabe and Ito, 2008). page.css has a variable of the same name for each.
function c = houseColours ()
  c = struct ('ink', '#1b1f24', 'axis', '#57606a', 'grid', '#e4e7ea', ...
              'blue', '#0072b2', 'red', '#d55e00', 'green', '#009e73', ...
              'pink', '#cc79a7', 'sky', '#56b4e9', 'amber', '#e69f00', ...
              'grey', '#8c959f', 'paleblue', '#d3e5f2', ...
              'midblue', '#a9cde6', 'palegreen', '#cdeadf', ...
              'palegrey', '#e9ecef', 'palered', '#f7dcc8');
end

%!testif ; ! isempty (file_in_path (getenv ('PATH'), 'gnuplot'))
%! f = newFigure ('T<1>', 'mu ''x''', 'y `a`', 'a "line"');
%! f = addLayer (f, 'area', [0, 1, 2; 1, 2, 3], 'paleblue');
%! f = addLayer (f, 'line', [0, 1; 1, 2], 'blue');
%! f = addLayer (f, 'disc', [0, 1; 1, 2], 'red');
%! svg = drawFigures ([f, f]){2};
%! assert (! isempty (strfind (svg, 'aria-label="a &quot;line&quot;"')));
%! assert (! isempty (strfind (svg, 'var(--paleblue)')));
%! assert (! isempty (strfind (svg, 'mu ''x''')));
%! assert (isempty (strfind (svg, 'rgb(')));
%! opened = numel (regexp (svg, '<g[ >]'));
%! assert (numel (strfind (svg, '</g>')), opened);
%! % nothing in it: axes all the same
%! svg = drawFigures (newFigure ('T', 'x', 'y', 'a')){1};
%! assert (! isempty (strfind (svg, '<text>')));
