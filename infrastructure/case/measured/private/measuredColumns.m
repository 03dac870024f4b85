% MEASUREDCOLUMNS  A table of measured values with the columns that it should have.
%
% CALL: [HEADER, CELLS, LINES] = measuredColumns (HEADER, CELLS, LINES, KNOWN)
%
%   HEADER, CELLS, LINES  of readCsvTable
%   KNOWN                 1 x m cell, names of the columns of measured.csv
%
% Names are taken in small letters, and mean, quantity, units, tolerance, n for
% value, name, unit, tol, repeats. "value [deg]" is the unit of all lines, that
% behind sd, sessionSd or tol goes to their fields. Trials in columns (value 1, trial 2)
% become lines, each with the unit of its column, as do columns that are named by
% results and hold numbers alone, and a table on its side is turned. Columns for
% people (remark ...) are left out. - and n/a are empty.

function [header, cells, lines] = measuredColumns (header, cells, lines, known)
  cells(isNoResult (cells)) = {''};
  if any (strcmpi (cells(:, 1), 'value')) && ...
      any (strcmpi (header{1}, {'name', 'series', 'quantity'}))
    whole = [header; cells]';
    [header, cells] = deal (whole(1, :), whole(2:end, :));
    lines = repmat (lines(1) - 1, rows (cells), 1);
  end
  [names, units] = parted (header, known);
  header(ismember (names, known)) = names(ismember (names, known));
  isRemark = ismember (lower (header), {'comment', 'comments', 'remark', ...
                                        'remarks', 'note', 'notes', ...
                                        'bemerkung', 'kommentar'});
  [header, cells] = deal (header(~isRemark), cells(:, ~isRemark));
  units = units(~isRemark);
  for name = {'sd', 'tol', 'sessionSd'}
    k = find (strcmp (header, name{1}) & ~cellfun (@isempty, units), 1);
    if ~isempty (k)
      isGiven = ~cellfun (@isempty, cells(:, k));
      cells(isGiven, k) = strcat (cells(isGiven, k), {' '}, units(k));
    end
  end
  table = struct ('header', {header}, 'cells', {cells}, 'lines', lines, ...
                  'units', {units});
  parts = struct2cell (trialsAsLines (table, known));
  [header, cells, lines, units] = parts{:};
  k = find (strcmp (header, 'value') & ~cellfun (@isempty, units), 1);
  if ~isempty (k)
    [header, cells] = withUnit (header, cells, units(k));
  end
end

% UNIT, of all lines or of each, where a line has none of its own.
function [header, cells] = withUnit (header, cells, unit)
  unit = repmat (unit(:), rows (cells) / numel (unit), 1);
  k = find (strcmp (header, 'unit'), 1);
  if isempty (k)
    header{end + 1} = 'unit';
    cells(:, end + 1) = unit;
  else
    isEmpty = cellfun (@isempty, cells(:, k));
    cells(isEmpty, k) = unit(isEmpty);
  end
end

% Names of columns in the words of KNOWN, and the unit in brackets behind.
function [names, units] = parted (header, known)
  parts = regexp (header, '^(.*?)\s*[[(]([^])]*)[])]$', 'tokens', 'once');
  [names, units] = deal (header, repmat ({''}, size (header)));
  isParted = ~cellfun (@isempty, parts);
  names(isParted) = cellfun (@(p) p{1}, parts(isParted), 'UniformOutput', false);
  units(isParted) = cellfun (@(p) p{2}, parts(isParted), 'UniformOutput', false);
  others = {'mean', 'value'; 'quantity', 'name'; 'result', 'name'; ...
            'target', 'name'; 'units', 'unit'; 'tolerance', 'tol'; ...
            'n', 'repeats'; 'trials', 'repeats'; ...
            'sessionsd', 'sessionSd'};
  for k = 1:numel (names)
    word = lower (names{k});
    at = find (strcmp (word, others(:, 1)), 1);
    if ~isempty (at) && ~any (strcmpi (names, others{at, 2}))
      word = others{at, 2};
    end
    if any (strcmp (word, known))
      names{k} = word;
    end
  end
end

% value 1, value 2 ..., or columns of numbers with the names of results.
function table = trialsAsLines (table, known)
  [header, cells, units] = deal (table.header, table.cells, table.units);
  trial = '^(value|trial|test|run|repeat)[ _.#]*\d+(\s*[[(][^])]*[])])?$';
  isTrial = ~cellfun (@isempty, regexpi (header, trial, 'once'));
  isNumber = all (~isnan (str2double (cells)) | cellfun (@isempty, cells), 1);
  isWide = ~ismember (header, known) & isNumber;
  isKey = ismember (header, {'name', 'series', 'value'});
  if any (isTrial) && any (isKey)
    move = find (isTrial | strcmp (header, 'value'));
    names = {};
  elseif ~any (isKey) && any (isWide) && all (isWide | ismember (header, known))
    move = find (isWide);
    names = regexprep (header(move), '\s*[[(][^])]*[])]$', '');
  else
    return
  end
  stay = setdiff (1:numel (header), move);
  isThere = ~cellfun (@isempty, cells(:, move));
  % a quantity without any value is one that is not measured yet
  if isempty (names)
    isThere(:, 1) = isThere(:, 1) | ~any (isThere, 2);
  else
    isThere(1, :) = isThere(1, :) | ~any (isThere, 1);
  end
  parts = cell (numel (move), 1);
  for j = 1:numel (move)
    part = [cells(:, stay), cells(:, move(j))];
    header_ = [header(stay), {'value'}];
    if ~isempty (names)
      part(:, end + 1) = names(j);
      header_{end + 1} = 'name';
    end
    if ~isempty (names) || ~all (cellfun (@isempty, units(move)))
      [header_, part] = withUnit (header_, part, units(move(j)));
    end
    parts{j} = part(isThere(:, j), :);
    from{j, 1} = table.lines(isThere(:, j));
  end
  table.cells = vertcat (parts{:});
  table.lines = vertcat (from{:});
  table.header = header_;
  table.units = repmat ({''}, size (header_));
  [~, at] = ismember (header(stay), header_);
  table.units(at) = units(stay);
end

%!function [header, cells, lines] = made (header, varargin)
%!  cells = vertcat (varargin{:});
%!  known = {'model', 'name', 'value', 'sd', 'unit', 'repeats', 'tol'};
%!  [header, cells, lines] = measuredColumns (header, cells, ...
%!                                            (2:rows (cells) + 1)', known);
%!endfunction
%!test
%! [h, c] = made ({'Quantity', 'Mean (deg)', 'SD [%]', 'n', 'Remark'}, ...
%!                {'slope', '31', '2', '5', 'x'}, {'off', '-', '', '', ''});
%! assert (h, {'name', 'value', 'sd', 'repeats', 'unit'});
%! assert (c, {'slope', '31', '2 %', '5', 'deg'; 'off', '', '', '', 'deg'});
%!test
%! [h, c, l] = made ({'name', 'value 1 [deg]', 'value 2 [deg]'}, ...
%!                   {'a', '31', '32'}, {'b', '5', ''});
%! assert (h, {'name', 'value', 'unit'});
%! assert (c, {'a', '31', 'deg'; 'b', '5', 'deg'; 'a', '32', 'deg'});
%! assert (l, [2; 3; 2]);
%! % each column has its unit; a line may have its own; what is not measured stays
%! [h, c] = made ({'name', 'value 1 [mm]', 'value 2 [m]'}, {'a', '20', '0.021'}, ...
%!                {'b', '', ''}, {'c', '1', ''});
%! assert ({h, c}, {{'name', 'value', 'unit'}, {'a', '20', 'mm'; 'b', '', 'mm'; ...
%!                                              'c', '1', 'mm'; 'a', '0.021', 'm'}});
%! [h, c] = made ({'name', 'value [mm]', 'unit'}, {'a', '3', 'kg'}, {'b', '20', ''});
%! assert ({h, c}, {{'name', 'value', 'unit'}, {'a', '3', 'kg'; 'b', '20', 'mm'}});
%!test
%! [h, c] = made ({'model', 'slope [deg]', 'mass'}, {'P', '31', '5'}, ...
%!                {'P', '32', ''});
%! assert (h, {'model', 'value', 'name', 'unit'});
%! assert (c, {'P', '31', 'slope', 'deg'; 'P', '32', 'slope', 'deg'; ...
%!             'P', '5', 'mass', ''});
%! [h, c] = made ({'name', 'slope', 'mass'}, {'value', '31', '5'}, ...
%!                {'unit', 'deg', 'kg'});
%! assert ({h, c}, {{'name', 'value', 'unit'}, {'slope', '31', 'deg'; ...
%!                                              'mass', '5', 'kg'}});

% SPDX-License-Identifier: GPL-3.0-only
