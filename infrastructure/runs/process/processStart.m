% PROCESSSTART  When a process started, as a mark that tells it from others.
%
% CALL: [START, MARK, ISSURE] = processStart (PID)
%
%   PID     process number
%   START   start of the process in ticks since boot (text); '' where there is
%           no such process, where it has ended and is only not yet cleared
%           away (a zombie), or where it cannot be seen
%   MARK    START, the boot, the command and the PID namespace in one text, as
%           guard.sh writes them: after a restart of the machine, or in another
%           container, the same number and even the same ticks may be those of
%           another process
%   ISSURE  logical; false where START is '' though there may be such a process:
%           /proc hides it (hidepid) or is that of another namespace
%
% Source: proc(5), fields 2, 3 and 22 of /proc/PID/stat,
% /proc/sys/kernel/random/boot_id; pid_namespaces(7).

function [start, mark, isSure] = processStart (pid)
  start = '';
  mark = '';
  fid = -1;
  if strcmp (readlink ('/proc/self'), sprintf ('%d', getpid ()))
    fid = fopen (sprintf ('/proc/%d/stat', pid), 'r');
  end
  if fid < 0
    isSure = isGone (pid);
    return
  end
  isSure = true;
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
    space = [regexprep(readlink ('/proc/self/ns/pid'), '\D', ''), '-'];
    space = space(1:max (1, end - 1));
    mark = strjoin ({start, boot, name, space}, ' ');
  end
end

% A process that is hidden gets no signal 0 either, for another reason; the
% words depend on the language.
function yes = isGone (pid)
  yes = false;
  if pid > 0
    [err, why] = kill (pid, 0);
    [~, none] = kill (2^30, 0);             % above all numbers there can be
    yes = err ~= 0 && strcmp (why, none);
  end
end

%!assert (processStart (2^30), '')
%!test
%! % a process that has ended but is still listed: its parent, by then no shell
%! % any more, never asks for it
%! file = tempname ();
%! system (sprintf (['sh -c ''sleep 60 & echo $! $$ > %s; ' ...
%!   'exec sleep 61'' > /dev/null 2>&1 &'], file));
%! waitUntil (@() isfile (file) && numel (sscanf (fileread (file), '%d')) == 2);
%! pids = sscanf (fileread (file), '%d');
%! of = @(pid, name) fileread (sprintf ('/proc/%d/%s', pid, name));
%! waitUntil (@() strcmp (of (pids(2), 'comm'), "sleep\n"));
%! kill (pids(1), 9);
%! waitUntil (@() any (strfind (of (pids(1), 'stat'), ') Z ')));
%! start = processStart (pids(1));
%! kill (pids(2), 9);
%! assert (start, '');
%! [start, mark] = processStart (getpid ());
%! words = strsplit (mark, ' ');
%! assert ({words{1}, numel(words{2}), numel(words)}, {start, 36, 4});
%! assert (~isempty (regexp (words{4}, '^(\d+|-)$', 'once')));
%! assert (strncmp (words{3}, 'octave', 6));
%!test
%! % nobody; one whose number nobody has; this one
%! [~, ~, isSure] = processStart (NaN);
%! assert (isSure, false);
%! [~, ~, isSure] = processStart (2^30);
%! assert (isSure, true);
%! [~, ~, isSure] = processStart (getpid ());
%! assert (isSure, true);

% SPDX-License-Identifier: GPL-3.0-only
