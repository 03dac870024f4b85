% CLAIMRUNS  Takes runs of a shared store, so that no other case makes them too.
%
% CALL: [ISMINE, HOLD] = claimRuns (JOBS, CASE)
%
%   JOBS    1 x n struct array, see newJobs;  CASE  see newCase
%   ISMINE  1 x n logical; false where another Octave of this machine is about
%           to make that very run
%   HOLD    cell of onCleanup objects: the runs are free when it is cleared
%
% A claim is a lock (lockCase) that names the key of the run. One of another
% machine, which nobody here can ask, does not count.
%
% See also: runJobs, lockCase

function [isMine, hold] = claimRuns (jobs, Case)
  isMine = true (1, numel (jobs));
  hold = {};
  if strcmp (Case.store, Case.folder)
    return
  end
  for i = 1:numel (jobs)
    folder = fullfile (Case.store, 'optim', jobs(i).model);
    [~, ~] = mkdir (folder);
    name = ['claim-', jobs(i).key];
    try
      hold{end + 1} = lockCase (folder, name);
    catch
      isMine(i) = ~strcmp (lockHolder (folder, name).state, 'alive');
    end
  end
end

%!test
%! raw = standInCase (tempname ());
%! raw.Input.store = tempname ();
%! Case = newCase (raw);
%! jobs = newJobs (Case, [1, 2; 3, 4], [], 1, 'plan');
%! [isMine, hold] = claimRuns (jobs(1:2), Case);
%! assert (isMine, true (1, 2));
%! assert (claimRuns (jobs, Case), [false, false, true, true]);
%! hold = {};
%! assert (claimRuns (jobs, Case), true (1, 4));
%! assert (numel (readdir (fullfile (Case.store, 'optim', 'First'))), 2);
%!test
%! % a run that another makes meanwhile is waited for, and not made again
%! raw = standInCase (tempname ());
%! raw.Input.store = tempname ();
%! Case = newCase (raw);
%! job = newJobs (Case, [1, 2], [], 1, 'plan')(1);
%! file = fullfile (raw.folder, 'case.mat');
%! save ('-binary', file, 'Case', 'job');
%! code = sprintf (['addpath (''%s''); startToolbox (''%s''); ', ...
%!                  'load (''%s''); ', ...
%!                  '[~, hold] = claimRuns (job, Case); ', ...
%!                  'fclose (fopen (''%s.on'', ''w'')); pause (3); ', ...
%!                  'Case.folder = Case.store; ', ...
%!                  'runJobs (job, Case, @(s) []);'], ...
%!                 fullfile (Case.root, 'infrastructure'), Case.root, ...
%!                 file, file);
%! system (['octave-cli --norc --eval ', shellQuote(code), ...
%!          ' > /dev/null 2>&1 &']);
%! while ~isfile ([file, '.on'])
%!   pause (0.2);
%! end
%! [r, ~, nNew] = runJobs (job, Case, @(s) []);
%! assert ({r.status, nNew}, {'ok', 0});
%! assert (numel (listRunFolders (Case.store, 'First')), 1);
