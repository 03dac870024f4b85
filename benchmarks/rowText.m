% ROWTEXT  A row of a table of results: texts, and numbers with four digits.
%
% CALL: LINE = rowText (CELLS)
%
%   CELLS  1 x n cell of texts without commas and numbers;  LINE  text
%
% See also: planStudy

function line = rowText (cells)
  isNumber = ~cellfun (@ischar, cells);
  cells(isNumber) = cellfun (@(v) sprintf ('%.4g', v), cells(isNumber), ...
                             'UniformOutput', false);
  line = strjoin (cells, ',');
end

%!assert (rowText ({'a', 1 / 3, '', true}), 'a,0.3333,,1')

% SPDX-License-Identifier: GPL-3.0-only
