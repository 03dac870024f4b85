% TABLEROWS  Rows of a CSV table, a struct each.
%
% CALL: LIST = tableRows (FILE)
%
%   FILE  path of a table with a header (text)
%   LIST  1 x n struct, a field a column, all texts
%
% See also: readCsvTable

function list = tableRows (file)
  [header, cells] = readCsvTable (file);
  list = cell2struct (cells, header, 2)';
end

%!test
%! file = tempname ();
%! writeAtomic (file, "a,b\n1,x\n2,y\n");
%! list = tableRows (file);
%! assert ({list.a, list.b}, {'1', '2', 'x', 'y'});

% SPDX-License-Identifier: GPL-3.0-only
