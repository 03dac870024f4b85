% ENDRUN  Ends a simulation that is under way, with all it has started.
%
% CALL: endRun (FOLDER)
%
%   FOLDER  folder of the run (text)
%
% Only processes that are surely of this run get a signal: the guard, where it
% is what it has noted of itself; where it is gone, what is left of the run's
% session and works in FOLDER.
%
% See also: startRun, executeLocal, runPids

function endRun (folder)
  [pids, isAlive, isHere] = runPids (folder);
  if isAlive
    system (sprintf ('kill -TERM %d 2> /dev/null', pids(1)));
  elseif isHere
    system (sprintf (['for p in $(pgrep -s %d); do case "$(readlink ', ...
                      '/proc/$p/cwd)/" in %s/*) kill -KILL $p;; esac; ', ...
                      'done 2> /dev/null'], pids(2), ...
                     shellQuote (canonicalize_file_name (folder))));
  end
  try
    if isempty (pids) && isfolder (folder)  % its guard is on the way perhaps
      writeAtomic (fullfile (folder, 'limit'), "0\n", false);
    end
  catch
    % a full disk: the guard sees that its Octave is gone
  end
end

%!function pid = session (folder)
%!  [~, ~] = mkdir (folder);
%!  system (sprintf ('cd %s && setsid sleep 1000 & echo $! > %s/number', ...
%!                   folder, folder));
%!  pid = str2double (fileread (fullfile (folder, 'number')));
%!endfunction
%!function yes = survives (pid, folder, text)
%!  writeAtomic (fullfile (folder, 'pid'), sprintf (text, pid));
%!  endRun (folder);
%!  pause (0.3);
%!  yes = ~isempty (processStart (pid));
%!endfunction
%!test
%! % a pid file from before a restart names a process that is not ours
%! folder = tempname ();
%! ours = session (folder);
%! assert (survives (ours, folder, '%d 999999999'));
%! [~, mark] = processStart (ours);         % it is no setsid any more
%! assert (survives (ours, folder, ['%d 9 1', mark]));
%! % the guard itself
%! assert (! survives (ours, folder, ['%d 9 ', mark]));
%! % what a guard that is gone has left behind, and a session of others
%! words = strsplit (mark, ' ');
%! ended = strjoin ([{'999999999 %d 1', words{2}, 'bash'}, words(4)], ' ');
%! left = session (folder);
%! endRun (tempname ());
%! assert (~isempty (processStart (left)));
%! other = session (tempname ());
%! assert (survives (other, folder, ended));
%! kill (other, 9);
%! assert (! survives (left, folder, ended));

% SPDX-License-Identifier: GPL-3.0-only
