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
% become lines, as do columns that are named by results and hold numbers alone,
% and a table on its side is turned. Columns for people (remark ...) are left
% out. - and n/a are empty.

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
  if ~isempty (k) && ~any (strcmp (header, 'unit'))
    header{end + 1} = 'unit';
    cells(:, end + 1) = units(k);
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
  n = rows (cells);
  parts = cell (numel (move), 1);
  for j = 1:numel (move)
    added = cell (n, 0);
    if ~isempty (names)
      added = repmat ([names(j), units(move(j))], n, 1);
    end
    keep = ~cellfun (@isempty, cells(:, move(j)));
    % a quantity without any value is one that is not measured yet
    keep(end) = keep(end) || (j == 1 && isempty (names));
    part = [cells(:, stay), cells(:, move(j)), added];
    parts{j} = part(keep, :);
    from{j, 1} = table.lines(keep);
  end
  table.cells = vertcat (parts{:});
  table.lines = vertcat (from{:});
  table.header = [header(stay), {'value'}];
  table.units = [units(stay), units(move(1))];
  if ~isempty (names)
    table.header = [table.header, {'name', 'unit'}];
    table.units = [table.units, {'', ''}];
  end
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
