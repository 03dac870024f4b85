% Runs through a real Slurm (slurm-up.sh) and everything that can happen to
% them. The blocks use one cluster, which the last of them stops.

%!shared cluster, home, config
%! cluster = '';
%! config = getenv ('SLURM_CONF');
%! home = tempname ();
%! mkdir (home);

% job number, guard and session of the run of a job
%!function [id, pids] = partsOf (folder, k)
%!  runs = glob (fullfile (folder, 'optim', 'First', '0*'));
%!  for i = 1:numel (runs)
%!    who = fileread (fullfile (runs{i}, 'batch.claim', 'who'));
%!    id = strtok (who);
%!    pids = runPids (runs{i});
%!    if strcmp (regexp (id, '\d+$', 'match', 'once'), num2str (k))
%!      return;
%!    end
%!  end
%!endfunction

%!function injure (folder)
%!  pause (0.5);
%!  id = partsOf (folder, 1);
%!  system (['scancel ', id]);
%!  [~, pids] = partsOf (folder, 2);
%!  system (sprintf ('kill -9 %d; pkill -9 -s %d', pids));
%!  [~, pids] = partsOf (folder, 3);
%!  system (sprintf ('pkill -9 -s %d', pids(2)));
%!endfunction

%!function restartDaemons (cluster)
%!  stop = ['p=$(cat %s/run/%s*.pid); kill -%s $p; ', ...
%!          'while kill -0 $p 2> /dev/null; do sleep 0.1; done; '];
%!  system ([sprintf(stop, cluster, 'slurmd', '9'), 'sleep 1; slurmd -N n1']);
%!  system ([sprintf(stop, cluster, 'slurmctld', 'TERM'), 'slurmctld']);
%!endfunction

%!testif ; slurmTestReady ()
%! cluster = slurmTestUp (8);

% the same plan, locally and through Slurm; a path that needs quoting
%!testif ; slurmTestReady ('quiet')
%! a = [1, 2, 9, 7, 8, 3.3];
%! [Case, jobs] = slurmTestCase (fullfile (home, 'it''s %a $1'), a, 0);
%! Case.models.timeout = 2;
%! r = slurmExecutor ().execute (jobs, Case, @(s) []);
%! [Case, jobs] = slurmTestCase (fullfile (home, 'local'), a, 0);
%! Case.models.timeout = 2;
%! q = executeLocal (jobs, Case, @(s) []);
%! assert ({r.status}, {'ok', 'ok', 'failed', 'invalid', 'timeout', 'ok'});
%! assert ({r.status}, {q.status});
%! assert ({r.cause}, {q.cause});
%! assert ({r.results}, {q.results});
%! assert (! isempty (strfind (r(3).message, 'too dense')));

% cancelled, guard killed, processes killed: records; the fourth run is ok
%!testif ; slurmTestReady ('quiet')
%! folder = fullfile (home, 'injured');
%! [Case, jobs] = slurmTestCase (folder, 1:4, 3);
%! r = slurmExecutor ().execute (jobs, Case, ...
%!                   @(s) slurmTestOnce (s, 4, folder, @() injure (folder)));
%! assert ({r.status}, {'failed', 'failed', 'failed', 'ok'});
%! assert ({r(1:3).cause}, {'killed', 'killed', 'killed'});
%! assert (! isempty (strfind (r(1).message, 'CANCELLED')));
%! assert (! isempty (strfind (r(2).message, 'FAILED')));
%! assert (all (cellfun (@(f) isfile (fullfile (f, 'record.json')), ...
%!                       {r.folder})));

% slurmd killed and restarted, slurmctld restarted in mid-plan; few at a time
%!testif ; slurmTestReady ('quiet')
%! folder = fullfile (home, 'daemons');
%! [Case, jobs] = slurmTestCase (folder, 1 + (1:12) / 100, 1);
%! r = slurmExecutor ().execute (jobs, Case, ...
%!                   @(s) slurmTestOnce (s, 1, folder, ...
%!                                       @() restartDaemons (cluster)));
%! assert (isfile (fullfile (folder, 'meddled')));
%! assert ({r.status}, repmat ({'ok'}, 1, 12));
%! assert (slurmTestStarts (folder), 12);
%! sums = sum (vertcat (jobs.params), 2)';
%! assert (cellfun (@(x) x(1), {r.results}), sums, 1e-12);

% Octave killed in mid-plan, and again: reattached, each run started once
%!testif ; slurmTestReady ('quiet')
%! folder = fullfile (home, 'killed');
%! for round = 1:2
%!   pid = slurmTestStart (folder, 1:6, 3);
%!   for wait = 1:100
%!     if slurmTestStarts (folder) >= 2
%!       break;
%!     end
%!     pause (0.1);
%!   end
%!   pause (0.5);
%!   kill (pid, 9);
%! end
%! [Case, jobs] = slurmTestCase (folder, 1:6, 3);
%! r = slurmExecutor ().execute (jobs, Case, @(s) []);
%! assert ({r.status}, repmat ({'ok'}, 1, 6));
%! assert (slurmTestStarts (folder), 6);
%! assert (r(6).results, [8, 12], 1e-12);
%! assert (numel (readdir (fullfile (folder, 'optim', '.slurm'))), 2);

% killed before sbatch: submitted again, and the first array is void for good
%!testif ; slurmTestReady ('quiet')
%! folder = fullfile (home, 'unsent');
%! [Case, jobs] = slurmTestCase (folder, 1:2, 0);
%! queue = slurmExecutor ();
%! queueState = batchAttach (jobs, Case, queue);
%! opt = queue.options (Case.options);
%! queueState = batchSubmit (queueState, 1:2, jobs, Case, queue, opt);
%! r = slurmExecutor ().execute (jobs, Case, @(s) []);
%! assert ({r.status}, {'ok', 'ok'});
%! [~, ~] = mkdir (queueState.batches.path);
%! here = fullfile (Case.root, 'infrastructure', 'runs', 'executors', 'queues');
%! task = [{fullfile(here, 'batchTask.sh'), queueState.batches.path, 'none'}, ...
%!         queue.task];
%! assert (queue.send (queueState.batches, opt, task), 'sent');
%! pause (2);
%! assert (slurmTestStarts (folder), 2);

% cancelled while nobody looked: the next start submits it again
%!testif ; slurmTestReady ('quiet')
%! folder = fullfile (home, 'cancelled');
%! pid = slurmTestStart (folder, 1:2, 2);
%! for wait = 1:100
%!   if slurmTestStarts (folder) >= 1
%!     break;
%!   end
%!   pause (0.1);
%! end
%! kill (pid, 9);
%! sent = {readSubmissions(fullfile (folder, 'optim', '.slurm')).name};
%! assert (numel (sent), 1);
%! assert (describeExecutor ('slurm').cancel (sent));
%! [Case, jobs] = slurmTestCase (folder, 1:2, 2);
%! r = slurmExecutor ().execute (jobs, Case, @(s) []);
%! assert ({r.status}, {'ok', 'ok'});

% refused: an error that quotes Slurm, and nothing left in the ledger
%!testif ; slurmTestReady ('quiet')
%! folder = fullfile (home, 'refused');
%! [Case, jobs] = slurmTestCase (folder, 1:2, 0);
%! Case.options.slurm.partition = 'nosuch';
%! try
%!   slurmExecutor ().execute (jobs, Case, @(s) []);
%! catch err
%! end
%! assert (err.identifier, 'DEcalioc:batchExecute:submitRefused');
%! assert (! isempty (strfind (err.message, 'partition')));
%! assert (isempty (readSubmissions (fullfile (folder, 'optim', '.slurm'))));
%! Case.options.slurm.partition = 'main';
%! r = slurmExecutor ().execute (jobs, Case, @(s) []);
%! assert ({r.status}, {'ok', 'ok'});

%!testif ; slurmTestReady ('quiet')
%! slurmTestDown (cluster);
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (home, 's');
%! setenv ('SLURM_CONF', config);

% SPDX-License-Identifier: GPL-3.0-only
