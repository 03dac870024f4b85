% SCRIPTCURVES  What decalioc new --curve says: which columns, and what was measured.
%
% CALL: CURVES = scriptCurves (TEXTS)
%
%   TEXTS   cell of texts PLACE:NAME=FILE or PLACE:NAME:UNIT=FILE: the columns of the
%           run's output, and a table of what was measured, in any form that
%           readCsvTable takes: the columns PLACE, NAME and sd by their names, else
%           the first two, place and value, or three with the standard uncertainty
%           of the value. A unit behind its name is that of NAME
%   CURVES  1 x n struct place, name, unit, atUnit (of the places in the table, '': it
%           names none), points (m x 2 or m x 3)
%
% Errors: DEcalioc:scriptCurves:badValue; those of readCsvTable

function curves = scriptCurves (texts)
  curves = struct ('place', {}, 'name', {}, 'unit', {}, 'atUnit', {}, ...
                   'points', {});
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
    curve = struct ('place', found{1}, 'name', found{2}, 'unit', unit, ...
                    'atUnit', '', 'points', []);
    [curve.points, curve.atUnit, curve.unit] = pointsOf (found{end}, curve);
    curves(end + 1) = curve;
  end
end

% The columns by their names; those that are not found take the others in their order.
function [points, atUnit, unit] = pointsOf (file, curve)
  [header, cells, lines] = readCsvTable (file, {curve.place, curve.name, 'sd'});
  [names, units] = parted (header);
  [isFound, at] = ismember (lower ({curve.place, curve.name, 'sd'}), lower (names));
  if ~all (isFound(1:2)) && any (columns (cells) == [2, 3])
    free = setdiff (1:columns (cells), at);
    open = find (at == 0)(1:min (end, numel (free)));
    at(open) = free(1:numel (open));
  elseif ~all (isFound(1:2)) || columns (cells) > 3 && strncmp (header{4}, 'column', 6)
    refuse (file, sprintf ('the columns %s', strjoin (header, ', ')));
  end
  at = at(at > 0);
  texts = cells(:, at);
  texts(isNoResult (texts)) = {''};
  isRow = ~any (cellfun (@isempty, texts(:, 1:2)), 2);
  [texts, lines] = deal (texts(isRow, :), lines(isRow));
  points = str2double (texts);
  isOpen = cellfun (@isempty, texts);      % no uncertainty beside this one
  isBad = ~isfinite (points) & ~isOpen | ...
          ~cellfun (@isempty, strfind (texts, ','));
  bad = find (any (isBad, 2), 1);
  if ~isempty (bad)
    refuse (file, sprintf ('%s in line %d', strjoin (texts(bad, :), ' '), lines(bad)));
  elseif rows (points) < 2
    refuse (file, sprintf ('%d such lines', rows (points)));
  elseif lines(1) == 1 && columns (points) == 3 && all (fix (points(:)) == points(:)) && ...
         all (points(:, 3) > abs (points(:, 2)))
    refuse (file, sprintf (['%s in line %d. Decimal commas between commas cannot be told ' ...
                            'apart: write %s.%s,%s'], strjoin (texts(1, :), ','), lines(1), ...
                           texts{1, :}));
  end
  atUnit = units{at(1)};
  unit = unitFor (curve, units{at(2)}, file);
end

function refuse (file, got)
  error ('DEcalioc:scriptCurves:badValue', ...
         ['%s must be a table of measured points, at least two lines of place and ' ...
          'value (a third column: standard uncertainty of the value), got %s.'], ...
         file, got);
end

% Of "force [N]" force and N.
function [names, units] = parted (header)
  parts = regexp (header, '^(.*?)\s*(?:[[(/]\s*([^])]*)[])]?)?$', 'tokens', 'once');
  names = cellfun (@(p) p{1}, parts, 'UniformOutput', false);
  units = cellfun (@(p) [p{2:end}], parts, 'UniformOutput', false);
end

% The unit of the table is that of the curve, unless --curve says one, too.
function unit = unitFor (curve, given, file)
  unit = curve.unit;
  if isempty (unit)
    unit = given;
  elseif ~isempty (given) && ~isequal (unitFactor (given, unit), 1)
    error ('DEcalioc:scriptCurves:badValue', ...
           ['%s of %s must be in %s, as --curve says, got %s. Convert the column, ' ...
            'or name the unit that the run has: a unit of the table that differs ' ...
            'from it would be another number.'], curve.name, file, unit, given);
  end
end

%!shared file
%! file = tempname ();
%!test
%! writeAtomic (file, "# by hand\ntime [s],force [N]\n0,1\n0.1,2.5\n0.2,3\n");
%! c = scriptCurves ({['t:F:N=', file], ['time:force=', file]});
%! assert ({c.place}, {'t', 'time'});
%! assert ([{c.unit}, {c.atUnit}], {'N', 'N', 's', 's'});
%! assert (c(1).points, [0, 1; 0.1, 2.5; 0.2, 3]);
%! writeAtomic (file, "0 1 0.1\n1 2 0.1\n");
%! assert (scriptCurves ({['t:F=', file]}).points, [0, 1, 0.1; 1, 2, 0.1]);
%! assert (isempty (scriptCurves ({})));
%!error id=DEcalioc:scriptCurves:badValue scriptCurves ({'force=2'})
%!error id=DEcalioc:readCsvTable:missingFile scriptCurves ({'t:force=/nowhere.csv'})
%!test
%! for text = {"0,5;520\n0,6;400\n", "t;n\n0,5;520\n;;\n0,6;400\n", ...
%!             "n [1];sd;t [s];remark\n520;;0,5;x\n400;;0,6;y\n3;1;-;z\n"}
%!   writeAtomic (file, text{1});
%!   assert (scriptCurves ({['t:n=', file]}).points(:, 1:2), [0.5, 520; 0.6, 400]);
%! end
%!test
%! % of one name the column is known, and so the other
%! writeAtomic (file, "force [N],t [s]\n1,0\n2,0.5\n");
%! c = scriptCurves ({['time:force=', file]});
%! assert ({c.points, c.unit, c.atUnit}, {[0, 1; 0.5, 2], 'N', 's'});
%! writeAtomic (file, "value,sd,time\n1,0.1,0\n2,0.2,0.5\n");
%! assert (scriptCurves ({['time:force=', file]}).points, [0, 1, 0.1; 0.5, 2, 0.2]);
%!function refused (file, text, what)
%!  writeAtomic (file, text);
%!  fail ('scriptCurves ({[''t:F:N='', file]})', what);
%!endfunction
%!test
%! refused (file, "t,F [mN]\n0,1\n1,2\n", 'in N, as --curve says, got mN');
%! refused (file, "0,5,5,20\n0,6,4,0\n", 'got the columns t, F, sd, column 4');
%! refused (file, "t,F\n0,1\n1,x\n", 'got 1 x in line 3');
%! refused (file, "t,F\n0,1\n", 'got 1 such lines');

% SPDX-License-Identifier: GPL-3.0-only
