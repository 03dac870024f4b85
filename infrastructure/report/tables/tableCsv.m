% TABLECSV  A table as text of a CSV file.
%
% CALL: TEXT = tableCsv (T)
%
%   T     see newTable
%   TEXT  a head, then a line a row; numbers with all digits; code, unit and
%         standard error of a column, and the end of an interval, in columns of
%         their own

function text = tableCsv (T)
  heads = cellfun (@withUnit, T.columns(:, 1), T.columns(:, 2), 'UniformOutput', false)';
  lines = cell (rows (T.cells) + 1, 0);
  for j = 1:numel (heads)
    fields = cellfun (@fieldsOf, T.cells(:, j), 'UniformOutput', false);
    fields = vertcat (fields{:});
    names = strcat (heads{j}, {'', ' code', ' unit', ' to', ' standard error'});
    isUsed = [true, any(~cellfun (@(x) isempty (x) || isequaln (x, NaN), ...
                                  fields(:, 2:end)), 1)];
    lines = [lines, [names(isUsed); fields(:, isUsed)]];
  end
  lines = cellfun (@csvLine, num2cell (lines, 2), 'UniformOutput', false);
  text = [strjoin(lines', "\n"), "\n"];
end

function fields = fieldsOf (c)
  value = {c.value, NaN};
  if isnumeric (c.value)
    value = num2cell (c.value(:)');
    value(end + 1:2) = {NaN};
  end
  fields = [value(1), {c.code, c.unit}, value(2), {c.sd}];
end

%!test
%! T = newTable (struct ('sources', []), 'x', 'X', ...
%!               {'a', '', ''; 'b', 'N', 'plain'; 'c', '', 'plain'}, ...
%!               {struct('value', 'r, s', 'code', 'k'), ...
%!                struct('value', 0.25, 'sd', 2), [1, 2]; 'q', NaN, 3});
%! assert (tableCsv (T), ["a,a code,b (N),b (N) standard error,c,c to\n", ...
%!                        "\"r, s\",k,0.25,2,1,2\n", "q,,,,3,\n"]);

% SPDX-License-Identifier: GPL-3.0-only
