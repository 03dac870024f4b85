% WRITETABLE  Writes a whole table of results below the lines that say what made it.
%
% CALL: writeTable (FILE, LINES)
%
%   FILE   path of the table;  LINES  cell of text, its header first
%
% See also: originLines, startTable

function writeTable (file, lines)
  lines = lines(:)';
  writeAtomic (file, [strjoin([originLines(), lines], "\n"), "\n"]);
end

%!test
%! file = tempname ();
%! writeTable (file, {'a,b', '1,2'});
%! assert (tableRows (file), struct ('a', '1', 'b', '2'));
%! assert (~isempty (originOf (file).date));

% SPDX-License-Identifier: GPL-3.0-only
