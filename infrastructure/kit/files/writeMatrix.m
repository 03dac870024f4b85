% WRITEMATRIX  Writes a matrix as CSV at full precision, whole or not at all.
%
% CALL: writeMatrix (FILE, M)
%       writeMatrix (FILE, M, NAMES)
%
%   FILE   path of the file (text)
%   M      n x m real
%   NAMES  cell of m column names for a head line (default: no head line)
%
% Reading the file gives the same bits (exactNumber).

function writeMatrix (file, M, names)
  head = '';
  if nargin > 2
    head = [strjoin(names(:)', ','), "\n"];
  end
  line = [strjoin(repmat ({'%s'}, 1, columns (M)), ','), "\n"];
  texts = arrayfun (@exactNumber, M.', 'UniformOutput', false);
  writeAtomic (file, [head, sprintf(line, texts{:})]);
end

%!test
%! file = tempname ();
%! M = [pi, 1e-300; NaN, -Inf];
%! writeMatrix (file, M);
%! assert (csvread (file), M);
%! writeMatrix (file, M, {'a', 'b'});
%! assert (strncmp (fileread (file), "a,b\n3.14159265358979", 20));

% SPDX-License-Identifier: GPL-3.0-only
