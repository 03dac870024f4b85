% APPENDVARIABLES  Appends the variables of a run to its data.head.
%
% CALL: appendVariables (FOLDER, VARIABLES)
%
% FOLDER     folder of the run (text), with a data.head
% VARIABLES  scalar struct of numbers, one field per variable
%
% The lines are those of headLines.

function appendVariables (folder, variables)
  file = fullfile (folder, 'data.head');
  writeAtomic (file, [fileread(file), "\n", headLines(variables)], false);
end

%!test
%! folder = tempname ();
%! mkdir (folder);
%! file = fullfile (folder, 'data.head');
%! writeAtomic (file, 'variable a equal 1');
%! appendVariables (folder, struct ('a', 0.1, 'b', 5e6));
%! d = headDefaults (file);
%! assert (d.a, 0.1);
%! assert (d.b, 5e6);
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (folder, 's');
