% PROCESSSTART  When a process started, as a mark that tells it from others.
%
% CALL: START = processStart (PID)
%
%   PID    process number
%   START  start of the process in ticks since boot (text); '' where there is
%          no such process, or where it has ended and is only not yet cleared
%          away (a zombie)
%
% Source: proc(5), fields 3 and 22 of /proc/PID/stat, counted after the name in
% brackets.
%
% See also: lockCase, executeLocal

function start = processStart (pid)
  start = '';
  fid = fopen (sprintf ('/proc/%d/stat', pid), 'r');
  if fid < 0
    return
  end
  stat = fgetl (fid);
  fclose (fid);
  if ~ischar (stat)
    return
  end
  fields = strsplit (strtrim (regexprep (stat, '^.*\)', '')), ' ');
  if ~any (strcmp (fields{1}, {'Z', 'X'}))
    start = fields{20};
  end
end

%!assert (! isempty (processStart (getpid ())))
%!assert (processStart (2^30), '')
%!test
%! % a process that has ended but is still listed
%! file = tempname ();
%! system (sprintf ('sh -c ''sleep 0 & echo $! > %s; exec sleep 2'' &', file));
%! pause (0.5);
%! pid = str2double (fileread (file));
%! assert (isfolder (sprintf ('/proc/%d', pid)));
%! assert (processStart (pid), '');
%! unlink (file);
