% APPENDLINE  Adds a line to a table of results, and prints it.
%
% CALL: appendLine (FILE, LINE)
%
%   FILE  path of the table, made where it is not there;  LINE  text
%
% See also: rowText, planStudy, wholeRuns

function appendLine (file, line)
  id = fopen (file, 'a');
  fprintf (id, '%s\n', line);
  fclose (id);
  printf ('%s\n', line);
end

%!test
%! file = tempname ();
%! assert (evalc ('appendLine (file, ''a%b''); appendLine (file, ''c'')'), ...
%!         "a%b\nc\n");
%! assert (fileread (file), "a%b\nc\n");
%! delete (file);

% SPDX-License-Identifier: GPL-3.0-only
