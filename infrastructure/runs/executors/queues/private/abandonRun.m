% ABANDONRUN  Gives a run up: no job of any array can start it any more.
%
% CALL: abandonRun (FOLDER)
%
%   FOLDER  run folder (text)
%
% Takes the claim that batchTask.sh needs, or marks the one there as void.

function abandonRun (folder)
  claim = fullfile (folder, 'batch.claim');
  [~, ~] = mkdir (claim);
  writeAtomic (fullfile (claim, 'void'), '');
end

%!test
%! folder = emptyFolder ();
%! abandonRun (folder);
%! abandonRun (folder);
%! assert (isfile (fullfile (folder, 'batch.claim', 'void')));
%! script = fullfile (fileparts (fileparts (which ('abandonRun'))), 'batchTask.sh');
%! put = @(name, text) writeAtomic (fullfile (folder, name), text);
%! free = @() rmdir (fullfile (folder, 'batch.claim'), 's');
%! put ('tasks', sprintf ("key\t%s\n", folder));
%! line = 'T=%d J=1 bash %s %s true T J %s 2> /dev/null';
%! run = @(k, varargin) system (sprintf (line, k, shellQuote (script), ...
%!                                       folder, [varargin{:}]));
%! assert ([run(1), run(2)], [94, 95]);
%! free ();
%! put ('true', '');
%! assert (run (1), 0);
%! who = fileread (fullfile (folder, 'batch.claim', 'who'));
%! assert (strncmp (who, '1_1 on ', 7));
%! assert (run (1), 94);
%! % what goes before a run sets its environment; where a line fails, the run
%! % is not started and says why
%! put ('true', "echo $X >> said\n");
%! put ('before', "touch planted\n");      % of earlier versions: not sourced
%! before = {"export X=5\n", "ls /nowhere # gone\n[ $? = 0 ] || return\n"};
%! for k = 1:2
%!   free ();
%!   status(k) = run (1, base64_encode (uint8 (before{k})));
%! end
%! assert (status, [0, 98]);
%! assert (! isfile (fullfile (folder, 'planted')));
%! assert (fileread (fullfile (folder, 'said')), "5\n");
%! assert (readEndMark (folder).code, 98);
%! assert (~ isempty (strfind (fileread (fullfile (folder, 'stderr.txt')), ...
%!                             '/nowhere')));

% SPDX-License-Identifier: GPL-3.0-only
