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
end

%!function pid = session (folder, text)
%!  system (sprintf ('cd %s && setsid sleep 1000 & echo $! > %s/number', ...
%!                   folder, folder));
%!  pid = str2double (fileread (fullfile (folder, 'number')));
%!  writeAtomic (fullfile (folder, 'pid'), sprintf (text, pid, pid));
%!endfunction
%!test
%! % a pid file from before a restart names a process that is not ours
%! folder = tempname ();
%! mkdir (folder);
%! ours = session (folder, '%d 999999999');
%! endRun (folder);
%! pause (0.3);
%! assert (~isempty (processStart (ours)));
%! [~, mark] = processStart (ours);
%! writeAtomic (fullfile (folder, 'pid'), sprintf ('%d 9 1%s', ours, mark));
%! endRun (folder);
%! pause (0.3);
%! assert (~isempty (processStart (ours)));
%! % the guard itself
%! writeAtomic (fullfile (folder, 'pid'), sprintf ('%d 9 %s', ours, mark));
%! endRun (folder);
%! pause (0.3);
%! assert (isempty (processStart (ours)));
%! % what a guard that is gone has left behind, and a session of others
%! ended = ['999999999 %d 1 ', strsplit(mark, ' '){2}, ' bash'];
%! left = session (folder, ended);
%! endRun (tempname ());
%! assert (~isempty (processStart (left)));
%! system (sprintf ('setsid sleep 1000 & echo $! > %s/other', folder));
%! other = str2double (fileread (fullfile (folder, 'other')));
%! writeAtomic (fullfile (folder, 'pid'), sprintf (ended, other));
%! endRun (folder);
%! pause (0.3);
%! assert (~isempty (processStart (other)));
%! kill (other, 9);
%! writeAtomic (fullfile (folder, 'pid'), sprintf (ended, left));
%! endRun (folder);
%! pause (0.3);
%! assert (isempty (processStart (left)));
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (folder, 's');
