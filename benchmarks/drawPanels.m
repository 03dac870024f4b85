% DRAWPANELS  Draws panels of curves as an SVG, with gnuplot.
%
% CALL: drawPanels (FILE, PANELS, NCOLUMNS, KEY)
%
% FILE     path of the SVG
% PANELS   1 x n struct: title, xlabel, ylabel (text), range (1 x 4: x and y,
%          NaN: as the data want), band (1 x 2: grey from y to y; empty: none),
%          curves (1 x c struct: x, y 1 x k; lo, hi 1 x k, empty: no bars)
% NCOLUMNS panels side by side
% KEY      1 x c cellstr, names of the curves, written once below; may be empty
%
% Errors: DEcalioc:drawPanels:runFailed
%
% See also: benchResponse
function drawPanels (file, panels, nColumns, key)
  nRows = ceil (numel (panels) / nColumns);
  foot = 30 * ~isempty (key);
  high = 230 * nRows + foot;
  script = {sprintf(["set terminal svg noenhanced size %d,%d ", ...
                     "font 'FreeSans,11'"], 290 * nColumns, high), ...
            sprintf("set output '%s'", file), ...
            sprintf(['set multiplot layout %d,%d margins 0.07,0.98,%g,%g ', ...
                     'spacing 0.07,%g'], nRows, nColumns, ...
                    (50 + foot) / high, 1 - 28 / high, 75 / high), ...
            "set tics nomirror", "set border 3", "set key off", ...
            "set grid lc rgb '#e0e0e0'"};
  for k = 1:numel (panels)
    script = [script, panelLines(panels(k), k == 1, key, high)];
  end
  script{end + 1} = "unset multiplot";
  name = [tempname(), '.gp'];
  fid = fopen (name, 'w');
  fprintf (fid, "%s\n", script{:});
  fclose (fid);
  [status, text] = system (sprintf ('gnuplot "%s" 2>&1', name));
  delete (name);
  if status ~= 0
    error ('DEcalioc:drawPanels:runFailed', ...
           'drawPanels: gnuplot must draw %s, got: %s', file, text);
  end
end

function lines = panelLines (p, isFirst, key, high)
  lines = {sprintf("set title '%s' offset 0,-0.5", p.title), ...
           sprintf("set xlabel '%s' offset 0,0.5", p.xlabel), ...
           sprintf("set ylabel '%s' offset 1,0", p.ylabel), ...
           ['set xrange ', rangeText(p.range(1:2))], ...
           ['set yrange ', rangeText(p.range(3:4))], 'unset object'};
  if ~isempty (p.band)
    lines{end + 1} = sprintf (['set object 1 rect from graph 0, first %g ', ...
                               'to graph 1, first %g fc rgb ''#dddddd'' ', ...
                               'fs noborder behind'], p.band);
  end
  lines{end + 1} = 'unset label';
  if isFirst
    for c = 1:numel (key)
      lines{end + 1} = sprintf (['set label %d ''%s'' at screen %g,%g ', ...
                                 'point lt %d pt %d ps 0.7 offset 1,0'], ...
                                c, key{c}, 0.03 + 0.19 * (c - 1), ...
                                14 / high, c, 3 + 2 * c);
    end
  end
  parts = {};
  data = {};
  for c = 1:numel (p.curves)
    curve = p.curves(c);
    style = sprintf ('lt %d lw 1.3 pt %d ps 0.6', c, 3 + 2 * c);
    if isempty (curve.lo)
      parts{end + 1} = ['''-'' with linespoints ', style];
      table = [curve.x; curve.y];
    else
      parts{end + 1} = ['''-'' with yerrorlines ', style];
      table = [curve.x; curve.y; curve.lo; curve.hi];
    end
    table = table(:, all (isfinite (table), 1));
    form = [strtrim(repmat ('%.8g ', 1, rows (table))), "\n"];
    data{end + 1} = [sprintf(form, table), 'e'];
  end
  lines = [lines, {['plot ', strjoin(parts, ', ')]}, data];
end

function text = rangeText (limits)
  ends = {'*', '*'};
  for k = find (isfinite (limits))
    ends{k} = sprintf ('%g', limits(k));
  end
  text = ['[', ends{1}, ':', ends{2}, ']'];
end

%!testif ; ! isempty (file_in_path (getenv ('PATH'), 'gnuplot'))
%! file = [tempname(), '.svg'];
%! curve = struct ('x', [0, 1], 'y', [1, NaN], 'lo', [], 'hi', []);
%! panel = struct ('title', 'slope (deg)', 'xlabel', 'x', 'ylabel', '', ...
%!                 'range', [0, 1, NaN, NaN], 'band', [0.5, 2], ...
%!                 'curves', curve);
%! drawPanels (file, [panel, panel], 2, {'a'});
%! text = fileread (file);
%! delete (file);
%! assert (numel (strfind (text, 'slope (deg)')), 2);
