% SETINPUT  Sets a value in the loadInput.m of a case.
%
% CALL: setInput (FOLDER, NAME, VALUE)
%
%   FOLDER  text, case folder
%   NAME    text, what is set: 'Input.maxNewRuns', 'optim.trials{1}'
%   VALUE   1 x n numbers
%
% The first assignment to NAME is replaced; where there is none, a line in front
% of the first of modelVars is added.
%
% See also: leftOutFolder, wholeRuns

function setInput (folder, name, value)
  file = fullfile (folder, 'loadInput.m');
  text = fileread (file);
  line = sprintf ('%s = %s;', name, mat2str (value, 8));
  old = [regexptranslate('escape', name), ' = [^;]*;'];
  if isempty (regexp (text, old, 'once'))
    old = '  modelVars\.';
    line = ['  ', line, "\n  modelVars."];
  end
  writeAtomic (file, regexprep (text, old, line, 'once'));
end

%!test
%! folder = emptyFolder ();
%! file = fullfile (folder, 'loadInput.m');
%! writeAtomic (file, "  a{1} = [1, ...\n 2];\n  b = 3;\n  modelVars.x = 1;\n");
%! setInput (folder, 'a{1}', [4, 5.5]);
%! setInput (folder, 'c', 6);
%! setInput (folder, 'c', 7);
%! assert (fileread (file), ["  a{1} = [4 5.5];\n  b = 3;\n  c = 7;\n" ...
%!                           "  modelVars.x = 1;\n"]);

% SPDX-License-Identifier: GPL-3.0-only
