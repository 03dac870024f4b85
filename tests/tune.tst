% decalioc tune: a cheaper run with the same results, and one whose results shift.

%!function folder = slowCase ()
%!  % results as of the stand-in; a run takes the longer the smaller n, e is off by n
%!  folder = tempname ();
%!  standInCase (folder);
%!  lines = {'Input.model = {''First''};', 'Input.cpu = 1;', ...
%!           'optim.targetVal = {[12, 25]};', 'optim.tolRes = {[0.01, 0.01]};'};
%!  writeLoadInput (folder, strjoin (lines, "\n"));
%!  model = fullfile (folder, 'DEMmodels', 'First');
%!  head = fullfile (model, 'data.head');
%!  writeAtomic (head, [fileread(head), "variable n equal 0\n"]);
%!  script = fullfile (model, 'runscript');
%!  text = strrep (fileread (script), 'e = v["e"];', ...
%!                 ['e = v["e"]; system ("sleep " (v["n"] > 0 ? 0.1 : 1)); ' ...
%!                  'e += v["n"];']);
%!  writeAtomic (script, text);
%!endfunction

%!test
%! % n = 1e-4 changes nothing, n = 0.5 shifts the results by 2 and 5 %
%! folder = slowCase ();
%! [status, out] = startCommand (folder, 'tune --vary n=0.0001,0.5 --repeats 2');
%! says = @(part) ~isempty (strfind (out, part));
%! assert (status, 0);
%! assert (says ('modelVars.n = 0.0001; in loadInput.m'), out);
%! coarse = 'Input.coarse{1} = struct (''variable'', ''n'', ''levels'', [0.5, 0]);';
%! assert (says (coarse), out);
%! % the runs are there: a second call takes them, and what it says can be pasted
%! [again, second] = startCommand (folder, 'tune --vary n=0.5 --repeats 2');
%! assert (again, 2);
%! assert (~isempty (strfind (second, coarse)), second);
%! assert (numel (listRunFolders (fullfile (folder, 'tune'), 'First')), 6);
%! file = fullfile (folder, 'loadInput.m');
%! writeAtomic (file, strrep (fileread (file), 'optim.tolfun', [coarse, "\noptim.tolfun"]));
%! [status, out] = startCommand (folder, 'check');
%! assert (status == 0, out);

%!test
%! % results that shift by more than a tenth are no level; an unknown name is told
%! folder = slowCase ();
%! [status, out] = startCommand (folder, 'tune --vary n=5 --repeats 2');
%! assert (status, 2);
%! assert (isempty (strfind (out, 'Input.coarse')), out);
%! [status, out] = startCommand (folder, 'tune --vary m=5');
%! assert (status, 1);
%! assert (~isempty (strfind (out, 'variable of a data.head')), out);

% SPDX-License-Identifier: GPL-3.0-only
