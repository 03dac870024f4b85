% SPREADRUNS  A table of runs with one row a run.
%
% CALL: TABLE = spreadRuns (TABLE)
%
%   TABLE  of readRunsTable. Columns of the kind trial (angle 1, angle 2 ...)
%          become rows, and so does a row with n and sd, the mean of n runs and
%          their standard deviation: n rows with this mean and this scatter stand
%          for it, which says the same of a mean response and of the noise.
%          Without sd a mean counts as one run
%
% Errors: DEcalioc:importRuns:badValue (n no whole number from 1 to 1000, sd no
% number from 0)

function table = spreadRuns (table)
  isSpread = ismember (table.kinds, {'trial', 'runs', 'scatter'});
  if ~any (isSpread)
    return
  end
  if any (strcmp (table.kinds, 'trial'))
    table = withTrials (table);
  end
  if any (strcmp (table.kinds, 'runs'))
    table = withMeans (table);
  end
  % seeds of the rows are not known
  table = withColumns (table, find (~ismember (table.kinds, ...
                                               {'runs', 'scatter', 'seed'})));
end

function table = withColumns (table, k)
  for name = {'header', 'names', 'kinds', 'cells'}
    table.(name{1}) = table.(name{1})(:, k);
  end
end

% One row for each trial; results that have no trials stand in the first.
function table = withTrials (table)
  isTrial = strcmp (table.kinds, 'trial');
  isResult = strcmp (table.kinds, 'result');
  wide = unique (table.names(isTrial));
  of = cellfun (@(name) find (strcmp (table.names, name) & ...
                              (isTrial | isResult)), wide, ...
                'UniformOutput', false);
  first = cellfun (@(k) k(1), of);
  alone = find (isResult & ~ismember (table.names, wide));
  parts = {};
  lines = {};
  for j = 1:max (cellfun (@numel, of))
    part = table.cells;
    for w = 1:numel (wide)
      part(:, first(w)) = {''};
      if j <= numel (of{w})
        part(:, first(w)) = table.cells(:, of{w}(j));
      end
    end
    keep = true (rows (part), 1);
    if j > 1
      part(:, alone) = {''};
      keep = ~all (cellfun (@isempty, part(:, first)), 2);
    end
    parts{j, 1} = part(keep, :);
    lines{j, 1} = table.lines(keep);
  end
  table.cells = vertcat (parts{:});
  table.lines = vertcat (lines{:});
  table.kinds(first) = {'result'};
  table = withColumns (table, setdiff (1:numel (table.names), ...
                                       setdiff ([of{:}], first)));
end

function table = withMeans (table)
  count = numbersOf (table, find (strcmp (table.kinds, 'runs')), ...
                     @(v) v >= 1 & v <= 1000 & v == fix (v), ...
                     'a whole number from 1 to 1000');
  count(isnan (count)) = 1;
  result = find (strcmp (table.kinds, 'result'));
  at = repelems (1:rows (table.cells), [1:numel(count); count']);
  number = cell2mat (arrayfun (@(m) 1:m, count', 'UniformOutput', false));
  cells = table.cells(at, :);
  for t = 1:numel (result)
    k = find (strcmp (table.kinds, 'scatter') & ...
              strcmp (table.names, table.names{result(t)}), 1);
    sd = NaN (size (count));
    if ~isempty (k)
      sd = numbersOf (table, k, @(v) v >= 0, 'a number from 0');
    end
    mean = str2double (table.cells(:, result(t)));
    for i = find (count' > 1)
      rowsOf = find (at == i);
      cells(rowsOf(2:end), result(t)) = {''};
      if isfinite (mean(i)) && isfinite (sd(i))
        values = mean(i) + sd(i) * deviations (count(i), t)(number(rowsOf));
        cells(rowsOf, result(t)) = arrayfun (@exactNumber, values, ...
                                             'UniformOutput', false);
      end
    end
  end
  % without any sd a mean is one run: empty rows beside it would be failed ones, as are
  % those of a row without a result
  isEmpty = all (cellfun (@isempty, cells(:, result)), 2)';
  keep = number == 1 | ~isEmpty | isEmpty(number == 1)(at);
  table.cells = cells(keep, :);
  table.lines = table.lines(at(keep));
end

% n x 1 with mean 0 and standard deviation 1; those of results T are orthogonal
% as far as there are as many.
function d = deviations (n, t)
  k = mod (t - 1, n - 1) + 1;
  d = sqrt (2 * (n - 1) / n) * cos (pi * k * ((1:n)' - 0.5) / n);
end

function values = numbersOf (table, k, isGood, expected)
  texts = table.cells(:, k);
  values = str2double (texts);
  texts(isNoResult (texts)) = {''};
  bad = find (~cellfun (@isempty, texts) & ~isGood (values), 1);
  if ~isempty (bad)
    error ('DEcalioc:importRuns:badValue', ...
           'importRuns: %s in line %d of %s must be %s, got ''%s''.', ...
           table.header{k}, table.lines(bad), table.file, expected, texts{bad});
  end
end

%!function table = spread (header, kinds, names, cells)
%!  table = spreadRuns (struct ('file', 'f', 'header', {header}, 'kinds', ...
%!    {kinds}, 'names', {names}, 'cells', {cells}, 'lines', (2:rows (cells) + 1)'));
%!endfunction
%!test
%! % three seeds in columns, one of which failed; the mass was weighed once
%! t = spread ({'a', 'x 1', 'm', 'x 2', 'x 3'}, ...
%!             {'parameter', 'trial', 'result', 'trial', 'trial'}, ...
%!             {'a', 'x', 'm', 'x', 'x'}, {'1', '30', '5', '31', ''; ...
%!                                         '2', '32', '6', '33', '34'});
%! assert (t.names, {'a', 'x', 'm'});
%! assert (t.cells, {'1', '30', '5'; '2', '32', '6'; '1', '31', ''; ...
%!                   '2', '33', ''; '2', '34', ''});
%! assert (t.lines, [2; 3; 2; 3; 3]);
%!test
%! % means of n runs: the rows have their mean and their scatter, apart from
%! % each other; without sd a mean is one run
%! t = spread ({'a', 'x', 'y', 'n', 'sx', 'sy'}, ...
%!             {'parameter', 'result', 'result', 'runs', 'scatter', 'scatter'}, ...
%!             {'a', 'x', 'y', 'n', 'x', 'y'}, ...
%!             {'1', '30', '5', '4', '2', '0.5'; '2', '32', '6', '3', '-', ''; ...
%!              '3', '33', '7', '', '', ''});
%! Z = str2double (t.cells(:, 2:3));
%! assert (mean (Z(1:4, :)), [30, 5], 1e-12);
%! assert (std (Z(1:4, :)), [2, 0.5], 1e-12);
%! assert (corr (Z(1:4, 1), Z(1:4, 2)), 0, 1e-12);
%! assert (Z(5:end, :), [32, 6; 33, 7]);
%! assert (t.kinds, {'parameter', 'result', 'result'});
%!error <n in line 2 of f must be a whole number> ...
%! spread ({'n'}, {'runs'}, {'n'}, {'2.5'});
%!error id=DEcalioc:importRuns:badValue ...
%! spread ({'x', 'n', 'sd'}, {'result', 'runs', 'scatter'}, {'x', 'n', 'x'}, ...
%!         {'1', '2', '-1'});

% SPDX-License-Identifier: GPL-3.0-only
