% NEWTABLE  What is said of one matter, once: for console, page and file.
%
% CALL: T = newTable (PAGE, NAME, TITLE, COLUMNS, CELLS [, NOTES])
%
%   PAGE     see shownResult: its sources hold the numbers
%   NAME     of its file results/tables/NAME.csv
%   TITLE    what the table shows
%   COLUMNS  c x 3 or c x 4 cell: label, unit (''), kind of its numbers (see
%            plainNumber; 'words': sentences), and 'page' where the console has
%            no room for it
%   CELLS    n x c cell, or 1 x n cell of its rows; the first column names the row.
%            Text; a number, or two, an interval; {SOURCE, STEP, ...}, the steps
%            that lead to it in PAGE.sources; or a scalar struct of value (one of
%            these) and sd (a number or steps, its standard error), class (of
%            page.css), title (tooltip), code (name in scripts), unit (of the row),
%            and in the first column factor: what numbers of the row (kinds plain,
%            error, change) are multiplied by to have it
%   NOTES    cellstr ({}), sentences below it
%   T        scalar struct name, title, columns, cells (of structs with all these
%            and from, sdFrom: 'gap/where/p'), notes; without rows it is shown
%            nowhere

function T = newTable (page, name, title, columns, cells, notes)
  if nargin < 6
    notes = {};
  end
  columns(:, end + 1:4) = {''};
  if all (cellfun (@iscell, cells(:)))
    cells = vertcat (cell (0, rows (columns)), cells{:});
  end
  T = struct ('name', name, 'title', title, 'columns', {columns}, ...
              'cells', {cellfun(@(c) cellOf (c, page), cells, 'UniformOutput', false)}, ...
              'notes', {notes(:)'});
  isAmount = ismember (columns(:, 3)', {'plain', 'error', 'change'}) & ...
             cellfun (@isempty, columns(:, 2)');
  for k = find (cellfun (@(c) isfield (c, 'factor'), T.cells(:, 1:min (1, end))))'
    T.cells(k, isAmount) = cellfun (@(c) inUnit (c, T.cells{k, 1}.factor), ...
                                    T.cells(k, isAmount), 'UniformOutput', false);
  end
end

% No number of a file any more.
function c = inUnit (c, factor)
  if isnumeric (c.value)
    c.value = c.value * factor;
    c.sd = c.sd * factor;
    [c.from, c.sdFrom] = deal ('');
  end
end

function c = cellOf (given, page)
  c = struct ('value', '', 'from', '', 'sd', [], 'sdFrom', '', 'class', '', ...
              'title', '', 'code', '', 'unit', '');
  if isstruct (given)
    c = mergeFields (c, given);
  else
    c.value = given;
  end
  [c.value, c.from] = numberAt (c.value, page);
  [c.sd, c.sdFrom] = numberAt (c.sd, page);
  if isnumeric (c.value) && isscalar (c.value) && c.sd < 1e-4 * abs (c.value)
    [c.sd, c.sdFrom] = deal (NaN, '');   % less than a digit that is shown
  end
end

function [x, from] = numberAt (x, page)
  from = '';
  if iscell (x)
    from = strjoin (cellfun (@num2str, x, 'UniformOutput', false), '/');
    x = jsonAt (page.sources, x);
    if ~isnumeric (x)
      x = [];
    end
  end
  if ~ischar (x) && (isempty (x) || ~all (isfinite (x(:))))
    [x, from] = deal (NaN, '');
  end
end

%!test
%! page.sources.gap = struct ('p', 0.25, 'range', [1; 2]);
%! T = newTable (page, 'x', 'X', {'a', '', ''; 'b', 'N', 'plain'}, ...
%!               {'r', {'gap', 'p'}; struct('value', 's', 'code', 'k'), {'gap', 'none'}});
%! assert (size (T.columns), [2, 4]);
%! assert ({T.cells{1, 2}.value, T.cells{1, 2}.from}, {0.25, 'gap/p'});
%! assert ({T.cells{2, 1}.value, T.cells{2, 1}.code}, {'s', 'k'});
%! assert (isnan (T.cells{2, 2}.value));
%! sd = @(x) newTable (page, 'x', 'X', {'a', '', ''}, {{struct('value', 31, 'sd', x)}}) ...
%!           .cells{1}.sd;
%! assert ([sd(6e-6), sd(0), sd(0.1)], [NaN, NaN, 0.1]);
%! % in the unit that somebody measured in
%! row = {struct('value', 's', 'unit', 'g', 'factor', 1000), {'gap', 'p'}, 3};
%! T = newTable (page, 'x', 'X', {'a', '', ''; 'b', '', 'plain'; 'c', '', 'z'}, {row});
%! assert ({T.cells{1, 2}.value, T.cells{1, 2}.from, T.cells{1, 3}.value}, {250, '', 3});

% SPDX-License-Identifier: GPL-3.0-only
