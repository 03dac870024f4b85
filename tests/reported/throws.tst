% A misspelt function in getResults: no file and line were said, and each of its
% runs was made a second time with another seed.

%!shared folder, funs
%! folder = reportedCase ('throws');
%! funs = fullfile (folder, 'DEMmodels', 'Bench', 'OctaveFuns', 'getResults.m');
%!test
%! % said before anything is run
%! [status, out] = startCommand (folder, 'check');
%! assert (status == 1, out);
%! assert (~isempty (strfind (out, ['''readResutls'' undefined ', ...
%!                                  '(getResults.m, line 2)'])), out);

%!test
%! % one that comes to light with a run: once, with its line
%! writeAtomic (funs, ["function res = getResults (model, folderName)\n", ...
%!                     "  global path\n  res = {NaN, NaN, NaN};\n", ...
%!                     "  if isfile ([path, 'optim/', model, '/', ", ...
%!                     "folderName, '/out.txt'])\n", ...
%!                     "    res = num2cell (load (missing));\n  end\nend\n"]);
%! [status, out] = startCommand (folder, 'check --try');
%! assert (status == 2, out);
%! assert (~isempty (strfind (out, '(getResults.m, line 5)')), out);

%! assert (numel (listRunFolders (folder, 'Bench')), 1);
%! % nor does a later start run it again; corrected, it is evaluated
%! [status, out] = startCommand (folder, 'check --try');
%! assert (status == 2, out);
%! writeAtomic (funs, strrep (fileread (funs), 'load (missing)', ...
%!                            ['load ([path, ''optim/'', model, ''/'', ' ...
%!                             'folderName, ''/out.txt''])']));
%! [status, out] = startCommand (folder, 'check --try');
%! assert (status == 0, out);
%! assert (numel (listRunFolders (folder, 'Bench')), 1);

% SPDX-License-Identifier: GPL-3.0-only
