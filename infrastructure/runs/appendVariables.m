% APPENDVARIABLES  Appends the variables of a run to its data.head.
%
% CALL: appendVariables (FOLDER, VARIABLES)
%
% FOLDER     folder of the run (text), with a data.head
% VARIABLES  scalar struct of numbers, one field per variable
%
% Each line reads: variable NAME equal VALUE, with 17 significant digits, so
% that no step of a parameter is too small to arrive.

function appendVariables (folder, variables)
  file = fullfile (folder, 'data.head');
  names = fieldnames (variables);
  lines = cell (1, numel (names));
  for k = 1:numel (names)
    lines{k} = sprintf ('variable %s equal %.17g\n', names{k}, ...
                        variables.(names{k}));
  end
  writeAtomic (file, [fileread(file), "\n", lines{:}], false);
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
