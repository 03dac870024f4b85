% WAITFORRUNS  Waits a moment for runs that another case is about to make.
%
% CALL: WAIT = waitForRuns (WAIT, N, HOLDER, CASE, SHOW)
%
%   WAIT    scalar struct: number (of runs that are waited for), since (time of
%           the last change of it), said (time of the last sentence; -Inf)
%   N       number of runs that are waited for now;  HOLDER  see claimRuns
%   CASE    see newCase;  SHOW  as REPORT of runJobs: told for whom it waits and
%           how long, after ten seconds and then every ten minutes
%
% The file decalioc.waits of the case folder says the same to decalioc status.

function wait = waitForRuns (wait, n, holder, Case, show)
  now = time ();
  if n ~= wait.number
    [wait.number, wait.since] = deal (n, now);
  end
  if isempty (holder)
    return
  end
  if now - wait.since > 10 && now - wait.said > 600
    wait.said = now;
    text = sprintf (['%d run(s) are about to be made by the case %s (process ' ...
                     '%d on %s). Waiting since %s; if none of them is there ' ...
                     '%g h after that, they are run here (Input.waitHours).'], ...
                    n, holder.note, holder.pid, holder.host, ...
                    strftime ('%Y-%m-%d %H:%M', localtime (wait.since)), ...
                    Case.options.waitHours);
    show (struct ('total', 0, 'done', 0, 'failed', 0, 'running', 0, ...
                  'message', text));
    try
      writeAtomic (fullfile (Case.folder, 'decalioc.waits'), text, false);
    catch
      % a full disk: it has been said
    end
  end
  pause (1);
end

%!test
%! % nothing at first; after ten seconds for whom, once; a run that came
%! folder = emptyFolder ();
%! Case = struct ('folder', folder, 'options', struct ('waitHours', 5));
%! holder = struct ('note', '/the/other', 'pid', 7, 'host', 'here');
%! wait = struct ('number', 0, 'since', 0, 'said', -Inf);
%! said = evalc (['wait = waitForRuns (wait, 3, holder, Case, ', ...
%!                '@(s) disp (s.message));']);
%! assert (said, '');
%! assert (time () - wait.since < 60);
%! wait.since = time () - 20;
%! said = evalc (['wait = waitForRuns (wait, 3, holder, Case, ', ...
%!                '@(s) disp (s.message));']);
%! assert (strncmp (said, '3 run(s) are about to be made by the case /the/', 47));
%! assert ([fileread(fullfile (folder, 'decalioc.waits')), "\n"], said);
%! assert (evalc (['wait = waitForRuns (wait, 3, holder, Case, ', ...
%!                 '@(s) disp (s.message));']), '');

% SPDX-License-Identifier: GPL-3.0-only
