% PROCESSSTART  When a process started, as a mark that tells it from others.
%
% CALL: [START, MARK] = processStart (PID)
%
%   PID    process number
%   START  start of the process in ticks since boot (text); '' where there is
%          no such process, or where it has ended and is only not yet cleared
%          away (a zombie)
%   MARK   START, the boot and the command in one text, as guard.sh writes
%          them: after a restart of the machine or of a container the same
%          number and even the same ticks may be those of another process
%
% Source: proc(5), fields 2, 3 and 22 of /proc/PID/stat, and
% /proc/sys/kernel/random/boot_id.

function [start, mark] = processStart (pid)
  start = '';
  mark = '';
  fid = fopen (sprintf ('/proc/%d/stat', pid), 'r');
  if fid < 0
    return
  end
  stat = fgetl (fid);
  fclose (fid);
  if ~ischar (stat)
    return
  end
  stat(stat > 127) = '?';                   % the command, in any encoding
  fields = strsplit (strtrim (regexprep (stat, '^.*\)', '')), ' ');
  if ~any (strcmp (fields{1}, {'Z', 'X'}))
    start = fields{20};
    name = regexprep (stat, {'^\d+ \(', '\)[^)]*$', '\s'}, {'', '', '_'});
    % '-' where the kernel does not tell, as guard.sh has it
    boot = strtok ([checkReadText('/proc/sys/kernel/random/boot_id'), '-']);
    mark = strjoin ({start, boot, name}, ' ');
  end
end

%!assert (processStart (2^30), '')
%!test
%! % a process that has ended but is still listed: its parent, by then no shell
%! % any more, never asks for it
%! file = tempname ();
%! system (sprintf (['sh -c ''sleep 60 & echo $! $$ > %s; ' ...
%!   'exec sleep 61'' > /dev/null 2>&1 &'], file));
%! while ~isfile (file) || numel (sscanf (fileread (file), '%d')) < 2
%!   pause (0.05);
%! end
%! pids = sscanf (fileread (file), '%d');
%! of = @(pid, name) fileread (sprintf ('/proc/%d/%s', pid, name));
%! while ~strcmp (of (pids(2), 'comm'), "sleep\n")
%!   pause (0.05);
%! end
%! kill (pids(1), 9);
%! while ~any (strfind (of (pids(1), 'stat'), ') Z '))
%!   pause (0.05);
%! end
%! start = processStart (pids(1));
%! kill (pids(2), 9);
%! assert (start, '');
%! [start, mark] = processStart (getpid ());
%! words = strsplit (mark, ' ');
%! assert ({words{1}, numel(words{2})}, {start, 36});
%! assert (strncmp (words{3}, 'octave', 6));
