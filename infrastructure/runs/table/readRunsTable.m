% READRUNSTABLE  A table of runs, and what its columns are.
%
% CALL: [TABLE, SPREAD] = readRunsTable (FILE, CASE)
%
%   FILE   path, in any form that readCsvTable takes; it may have a row of units
%          below the header, or lie on its side (a column a run)
%   CASE   see importRuns
%   TABLE  scalar struct: file, header (as it stands there), names and kinds (see
%          importHeader), cells (n x c texts; a result without its unit), lines
%          (n x 1)
%   SPREAD  as TABLE, with one row a run, see spreadRuns
%
% Errors: those of readCsvTable, importHeader and spreadRuns;
% DEcalioc:importRuns:badValue (two columns of one parameter that differ)

function [table, spread] = readRunsTable (file, Case)
  [header, cells, lines] = readCsvTable (file);
  if isOnSide (header, cells, Case, file)
    whole = [header; cells]';
    [header, cells] = deal (whole(1, :), whole(2:end, :));
    lines = repmat (lines(1) - 1, rows (cells), 1);
  end
  [names, kinds] = importHeader (header, Case, file);
  isNumber = ismember (kinds, {'parameter', 'effect', 'result', 'trial'});
  if isUnits (cells, isNumber)
    isSaid = ~ismember (cells(1, :), {'', '-', '[-]', '1'});
    units = regexprep (cells(1, :), '^[[(](.*)[])]$', '$1');
    header(isSaid) = strcat (header(isSaid), {' ['}, units(isSaid), {']'});
    [names, kinds] = importHeader (header, Case, file);
    [cells, lines] = deal (cells(2:end, :), lines(2:end));
  end
  refuseTwice (header, names, kinds, cells, Case, file);
  for k = find (ismember (kinds, {'result', 'trial'}))
    t = find (strcmp (names{k}, {Case.targets.name}), 1);
    cells(:, k) = withoutUnit (cells(:, k), ...
                               givenField (Case.targets(t), 'unit', ''));
  end
  table = struct ('file', file, 'header', {header}, 'names', {names}, ...
                  'kinds', {kinds}, 'cells', {cells}, 'lines', lines);
  if nargout > 1
    spread = spreadRuns (table);
  end
end

% A pair of types that stands in both orders is no mistake, unless its values differ; nor
% are x and x [mm].
function refuseTwice (header, names, kinds, cells, Case, file)
  later = find (strcmp (kinds, 'ignored'));
  [again, kind] = importHeader (header(later), Case, file);
  for k = find (ismember (kind, {'parameter', 'effect', 'result'}))
    at = find (strcmp (names, again{k}) & strcmp (kinds, kind{k}), 1);
    if ~isempty (at) && ~isequal (cells(:, at), cells(:, later(k)))
      error ('DEcalioc:importRuns:badValue', ...
             ['importRuns: two columns of %s are %s, and differ: %s and %s. Rename the one ' ...
              'that is something else.'], file, again{k}, header{[at, later(k)]});
    end
  end
end

% Names in the first column, and none of them in the first line.
function yes = isOnSide (header, cells, Case, file)
  [names, kinds] = importHeader (header, Case, file);
  yes = columns (cells) > 1 && ~any (strcmp (kinds(2:end), 'parameter')) && ...
        ~all (ismember (Case.names, names)) && ...
        all (ismember (Case.names, ...
                       importHeader ([header(1); cells(:, 1)]', Case, file)));
end

% A first row that has no number, but a unit.
function yes = isUnits (cells, isNumber)
  yes = false;
  if rows (cells) > 1 && any (isNumber)
    texts = regexprep (cells(1, isNumber), '^[[(](.*)[])]$', '$1');
    isUnit = ~cellfun (@(u) isempty (u) || strcmp (u, '-') || ...
                       isnan (unitFactor (u, 'm')), texts);
    yes = all (isnan (str2double (texts)) | strcmp (texts, '1')) && any (isUnit);
  end
end

function texts = withoutUnit (texts, unit)
  said = [texts{:}];
  if isempty (unit) || ~any (double (said) > double ('9') & lower (said) ~= 'e')
    return
  end
  words = regexp (texts, '^([-+.\d]+(?:[eE][-+]?\d+)?)\s*([^-+\s.\d].*)$', ...
                  'tokens', 'once');
  for k = find (~cellfun (@isempty, words))'
    if isequal (unitFactor (words{k}{2}, unit), 1)
      texts{k} = words{k}{1};
    end
  end
end

%!function table = read (text)
%!  Case = struct ('names', {{'a', 'b'}}, 'effectVars', {{}});
%!  Case.targets = struct ('name', {'angle', 'mass'}, 'unit', {'deg', ''});
%!  file = tempname ();
%!  writeAtomic (file, text);
%!  table = readRunsTable (file, Case);
%!endfunction
%!test
%! t = read ("a,b,angle,mass\n-,[m],deg,\n1,2,30 deg,4\n");
%! assert (t.cells, {'1', '2', '30', '4'});
%! assert (t.header, {'a', 'b [m]', 'angle [deg]', 'mass'});
%! assert (t.lines, 3);
%! t = read ("a,1,2\nb,3,4\nangle,30,31\nmass,5,\n");
%! assert (t.cells, {'1', '3', '30', '5'; '2', '4', '31', ''});
%! assert (t.kinds, {'parameter', 'parameter', 'result', 'result'});
%!assert (read ("a,b,angle,Angle [deg],mass\n1,2,30,30,4\n").cells(1:3), {'1', '2', '30'})
%!error <two columns of .* are angle, and differ: angle and Angle \[deg\]> ...
%! read ("a,b,angle,Angle [deg],mass\n1,2,30,31,4\n")
%!error <must be in deg> read ("a,b,angle,mass\n,,rad,\n1,2,0.5,4\n")

% SPDX-License-Identifier: GPL-3.0-only
