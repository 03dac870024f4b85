% The main scripts as a part of something larger: a script of the user's, two
% cases in one running Octave, help and errors at the prompt.

%!shared root, base, first, second
%! root = fileparts (which ('DEcalioc'));
%! base = tempname ();
%! first = fullfile (base, 'first');
%! second = fullfile (base, 'second');
%! for folder = {first, second}
%!   standInCase (folder{1});
%!   writeLoadInput (folder{1}, ['optim.tolRes = {[0.05, 0.05], 0.1}; ', ...
%!                               'optim.maxFunEvals = 8;']);
%! end
%! writeLoadInput (second, ['optim.targetVal = {[9, 20], 1}; ', ...
%!                          'optim.tolRes = {[0.05, 0.05], 0.1}; ', ...
%!                          'optim.maxFunEvals = 8;']);
%! % the first case has a costFunction of its own, of no use for another
%! writeAtomic (fullfile (first, 'costFunction.m'), ...
%!   strrep (fileread (fullfile (root, 'costFunction.m')), ...
%!           '  result =', ["  assert (strcmp (pwd (), '", first, ...
%!                           "'));\n  result ="]));

%!function [status, out, err] = atPrompt (folder, code)
%!  root = fileparts (which ('DEcalioc'));
%!  [status, out, err] = startProgram (folder, ['--eval ', shellQuote( ...
%!    sprintf ('addpath (''%s''); %s', root, code))]);
%!endfunction

%!test
%! % a script of the user's goes on behind DEcalioc: two cases one after the
%! % other in one Octave, the second with nothing of the first one's
%! writeAtomic (fullfile (base, 'sweep.m'), sprintf ([ ...
%!   "addpath ('%s');\nroot = 'mine';\nfor name = {'first', 'second'}\n", ...
%!   "  cd (['%s', '/', name{1}]);\n  DEcalioc;\n", ...
%!   "  printf ('SET %%s %%.4f %%.4f\\n', name{1}, ", ...
%!   "calibration.params);\nend\n", ...
%!   "printf ('LAST %%s\\n%%s\\n', root, which ('costFunction'));\n", ...
%!   "exit (7);\n"], root, base));
%! [status, out, err] = startProgram (base, 'sweep.m');
%! assert (err, '');
%! assert (status == 7, out);
%! sets = regexp (out, '^SET (\w+) (\S+) (\S+)$', 'tokens', 'lineanchors');
%! assert (numel (sets), 2);
%! assert (cellfun (@str2double, sets{1}(2:3)), [4, 3], 0.3);
%! assert (cellfun (@str2double, sets{2}(2:3)), [5, 4], 0.4);
%! last = strsplit (strtrim (out), "\n")(end - 1:end);
%! assert (last, {'LAST mine', fullfile(root, 'costFunction.m')});

%!test
%! % an error is one: a script can catch it, the prompt stays
%! writeLoadInput (first, 'Input.maxCPU = -1;');
%! [status, out, err] = atPrompt (first, ['try, DEcalioc; catch e, ', ...
%!   'disp (e.identifier); end; try, diagnoseGap; catch e, ', ...
%!   'disp (e.message); end; disp (''still here''); exit (5);']);
%! assert (status == 5, err);
%! lines = strsplit (strtrim (out), "\n");
%! assert (lines{1}, 'DEcalioc:checkCase:badMaxCPU');
%! assert (! isempty (strfind (out, 'Input.maxCPU')));
%! assert (lines{end}, 'still here');

%!test
%! % help prints the head of the file
%! for name = {'DEcalioc', 'diagnoseGap'}
%!   [status, out, err] = atPrompt (base, ['help ', name{1}]);
%!   assert (status == 0, err);
%!   head = fileread (fullfile (root, [name{1}, '.m']));
%!   head = regexp (head, '^(?:%[^\n]*\n)+', 'match', 'once');
%!   head = regexp (head, '^% +(.*)$', 'tokens', 'lineanchors', ...
%!                  'dotexceptnewline');
%!   assert (numel (head) > 8);
%!   for line = [head{:}]
%!     assert (! isempty (strfind (out, line{1})), line{1});
%!   end
%! end

%!test
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (base, 's');

% SPDX-License-Identifier: GPL-3.0-only
