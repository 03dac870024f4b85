% Issue 53, stranger 11: a spreadsheet ends each line, the header too, with
% separators of columns that are empty.

%!test
%! folder = reportedCase ('emptyColumns', 'pile');
%! [status, out] = startCommand (folder, 'check');
%! assert (status == 0, out);
%! assert (! isempty (strfind (out, 'runs.csv  6 sets taken in')), out);

% SPDX-License-Identifier: GPL-3.0-only
