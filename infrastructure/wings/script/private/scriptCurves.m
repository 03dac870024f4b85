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
%           names none), points (m x 2 or m x 3), note ('' or a sentence: columns of
%           other names that were taken in their order)
%
% Errors: DEcalioc:scriptCurves:badValue; those of readCsvTable

function curves = scriptCurves (texts)
  curves = struct ('place', {}, 'name', {}, 'unit', {}, 'atUnit', {}, ...
                   'points', {}, 'note', {});
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
                    'atUnit', '', 'points', [], 'note', '');
    [curve.points, curve.atUnit, curve.unit, curve.note] = pointsOf (found{end}, curve);
    curves(end + 1) = curve;
  end
end

% The columns by their names; those that are not found take the others in their order.
function [points, atUnit, unit, note] = pointsOf (file, curve)
  [header, cells, lines] = readCsvTable (file, {curve.place, curve.name, 'sd'});
  [names, units] = parted (header);
  [isFound, at] = ismember (lower ({curve.place, curve.name, 'sd'}), lower (names));
  free = setdiff (1:columns (cells), at);
  open = find (~isFound(1:2));
  if ~isempty (open) && numel (free) ~= numel (open) || ...
     columns (cells) > 3 && strncmp (header{4}, 'column', 6)
    refuse (file, sprintf ('the columns %s', strjoin (header, ', ')));
  end
  at(open) = free(1:numel (open));
  note = '';
  if numel (open) == 2
    note = sprintf ('%s: its column %s is taken as %s, %s as %s', file, header{at(1)}, ...
                    curve.place, header{at(2)}, curve.name);
  end
  at = at(at > 0);
  if isUnits (cells(1:end * (rows (cells) > 1), at(1:2)))
    units(at(1:2)) = regexprep (cells(1, at(1:2)), '[][()]', '');
    [cells, lines] = deal (cells(2:end, :), lines(2:end));
  end
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
  elseif lines(1) == 1
    refuseThree (file, points, texts);
  end
  atUnit = units{at(1)};
  unit = unitFor (curve, units{at(2)}, file);
end

% Three numbers without names: line numbers, or decimal commas between commas.
function refuseThree (file, points, texts)
  if columns (points) == 3 && all (points(:, 3) > abs (points(:, 2)))
    cure = 'Name the columns in a first line';
    if all (fix (points(:)) == points(:))
      cure = sprintf (['Decimal commas between commas cannot be told apart: write ' ...
                       '%s.%s,%s'], texts{1, :});
    end
    refuse (file, sprintf ('%s in line 1, an uncertainty above its value. %s', ...
                           strjoin (texts(1, :), ','), cure));
  end
end

function refuse (file, got)
  error ('DEcalioc:scriptCurves:badValue', ...
         ['%s must be a table of measured points, at least two lines of place and ' ...
          'value (a third column, sd: standard uncertainty of the value), got %s.'], ...
         file, got);
end

% A row of units below the header.
function yes = isUnits (cells)
  yes = ~isempty (cells) && ...
        ~any (cellfun (@(u) isnan (unitFactor (u, 'm')), ...
                       regexprep (cells(1, :), '[][()]', '')));
end

% Of "force [N]" force and N; of a column without a name ''.
function [names, units] = parted (header)
  parts = regexp (header, '^(.*?)\s*(?:[[(/]\s*([^])]*)[])]?)?$', 'tokens', 'once');
  names = cellfun (@(p) ['', p{1:min(1, end)}], parts, 'UniformOutput', false);
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
%! % a column of row numbers without a name; a row of units; columns of other names
%! writeAtomic (file, ",t,F\n0,0.5,520\n1,0.6,400\n");
%! assert (scriptCurves ({['t:F=', file]}).points, [0.5, 520; 0.6, 400]);
%! writeAtomic (file, "t;F\n(s);N\n0,5;520\n0,6;400\n");
%! c = scriptCurves ({['t:F=', file]});
%! assert ({c.points, c.unit, c.atUnit, c.note}, {[0.5, 520; 0.6, 400], 'N', 's', ''});
%! writeAtomic (file, "load (N),x\n1,2\n2,3\n");
%! assert (! isempty (strfind (scriptCurves ({['t:F=', file]}).note, ...
%!                             'its column load (N) is taken as t, x as F')));
%! % a third column that is no uncertainty
%! refused (file, "t,F 1,F 2\n0.5,520,524\n0.6,400,404\n", 'got the columns t, F 1, F 2');
%! refused (file, "1,0.5,520\n2,0.6,400.5\n", 'Name the columns in a first line');
%!test
%! refused (file, "t,F [mN]\n0,1\n1,2\n", 'in N, as --curve says, got mN');
%! refused (file, "0,5,5,20\n0,6,4,0\n", 'got the columns t, F, sd, column 4');
%! refused (file, "t,F\n0,1\n1,x\n", 'got 1 x in line 3');
%! refused (file, "t,F\n0,1\n", 'got 1 such lines');

% SPDX-License-Identifier: GPL-3.0-only
