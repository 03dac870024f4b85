% SCRIPTCURVES  What decalioc new --curve says: which columns, and what was measured.
%
% CALL: CURVES = scriptCurves (TEXTS)
%
%   TEXTS   cell of texts PLACE:NAME=FILE or PLACE:NAME:UNIT=FILE: the columns of the
%           run's output, and a table of what was measured: two columns, place and
%           value, or three with the standard uncertainty of the value
%   CURVES  1 x n struct place, name, unit (texts), points (m x 2 or m x 3)
%
% Errors: DEcalioc:scriptCurves:badValue

function curves = scriptCurves (texts)
  curves = struct ('place', {}, 'name', {}, 'unit', {}, 'points', {});
  for text = texts
    found = regexp (text{1}, '^([A-Za-z]\w*):([A-Za-z]\w*)(?::([^=:]+))?=(.+)$', 'tokens', ...
                    'once');
    if isempty (found)
      error ('DEcalioc:scriptCurves:badValue', ...
             ['--curve must be given as PLACE:NAME=FILE, the two columns of the ' ...
              'output and a table of measured points (time:force=points.csv; with ' ...
              'a unit time:force:N=points.csv), got %s.'], text{1});
    end
    unit = '';
    if numel (found) == 4
      unit = found{3};
    end
    curves(end + 1) = struct ('place', found{1}, 'name', found{2}, 'unit', unit, ...
                              'points', pointsOf (found{end}));
  end
end

function points = pointsOf (file)
  points = [];
  if isfile (file)
    text = plainTable (strrep (readText (file), "\r", ''));
    lines = strsplit (strtrim (text), "\n");
    rows_ = cellfun (@numbersOf, lines, 'UniformOutput', false);
    isRow = cellfun (@(r) any (numel (r) == [2, 3]) && all (isfinite (r)), rows_);
    points = vertcat (rows_{isRow}, []);
  end
  if rows (points) < 2
    error ('DEcalioc:scriptCurves:badValue', ...
           ['%s must be a table of measured points, place and value in each line ' ...
            '(a third column: standard uncertainty), got %d such lines. Numbers ' ...
            'have decimal points.'], file, rows (points));
  end
end

function values = numbersOf (line)
  values = str2double (strsplit (strtrim (line), {"\t", ',', ';'}));
end

%!shared file
%! file = tempname ();
%!test
%! writeAtomic (file, "# by hand\ntime [s],force [N]\n0,1\n0.1,2.5\n0.2,3\n");
%! c = scriptCurves ({['t:F:N=', file], ['time:force=', file]});
%! assert ({c.place}, {'t', 'time'});
%! assert ({c.unit}, {'N', ''});
%! assert (c(1).points, [0, 1; 0.1, 2.5; 0.2, 3]);
%! writeAtomic (file, "0 1 0.1\n1 2 0.1\n");
%! assert (scriptCurves ({['t:F=', file]}).points, [0, 1, 0.1; 1, 2, 0.1]);
%! assert (isempty (scriptCurves ({})));
%!error id=DEcalioc:scriptCurves:badValue scriptCurves ({'force=2'})
%!error id=DEcalioc:scriptCurves:badValue scriptCurves ({'t:force=/nowhere.csv'})
