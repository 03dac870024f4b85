% CLAIMRUNS  Claims runs of a shared store, so that two cases do not make them.
%
% CALL: [ISMINE, HOLD, HOLDER] = claimRuns (JOBS, CASE)
%
%   JOBS    1 x n struct array, see newJobs
%   CASE    see newCase; where Input.store is the case folder all runs are its
%           own
%   ISMINE  1 x n logical, false where another Octave of this machine is about
%           to make that very run. One that cannot be seen from here (another
%           machine), whom nobody can ask, does not count, nor does this case:
%           it claims a run, then the one that this starts from
%   HOLD    the runs are free when it is cleared
%   HOLDER  of the last that is not, see lockHolder; its note names the case
%
% A claim is a lock that names the key of the run.

function [isMine, hold, holder] = claimRuns (jobs, Case)
  isMine = true (1, numel (jobs));
  hold = {};
  holder = [];
  if ~sharesStore (Case)
    return
  end
  for i = 1:numel (jobs)
    folder = runPlace (Case, jobs(i).model);
    [~, ~] = mkdir (folder);
    name = ['claim-', jobs(i).key];
    try
      hold{end + 1} = lockCase (folder, name, Case.folder);
    catch
      other = lockHolder (folder, name);
      isMine(i) = ~strcmp (other.state, 'alive') || ...
                  other.pid == getpid () && strcmp (other.note, Case.folder);
      if ~isMine(i)
        holder = other;
      end
    end
  end
end

%!test
%! Case = struct ('store', tempname (), 'folder', '/a');
%! jobs = struct ('model', 'M', 'key', {'k1', 'k2'});
%! [isMine, hold] = claimRuns (jobs(1), Case);
%! assert (isMine);
%! Case.folder = '/b';
%! [isMine, ~, holder] = claimRuns (jobs, Case);
%! assert (isMine, [false, true]);
%! assert ({holder.note, holder.pid}, {'/a', getpid()});
%! Case.folder = '/a';
%! assert (claimRuns (jobs(1), Case));
%! Case.folder = '/b';
%! hold = {};
%! assert (claimRuns (jobs, Case), [true, true]);

% SPDX-License-Identifier: GPL-3.0-only
