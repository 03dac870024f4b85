% What takes minutes: random kills of Octave, a node that is lost, a controller
% that is away, Slurm's own time limit, preemption. Only with DECALIOC_SOAK=1.

%!shared cluster, home, config
%! cluster = '';
%! config = getenv ('SLURM_CONF');
%! home = tempname ();
%! mkdir (home);

%!function ready = soakReady ()
%!  ready = strcmp (getenv ('DECALIOC_SOAK'), '1') && slurmTestReady ('quiet');
%!endfunction

% ends a daemon and starts it again after some seconds, without waiting
%!function interrupt (cluster, daemon, seconds)
%!  start = strrep (daemon, 'slurmd-', 'slurmd -N ');
%!  system (sprintf (['kill -9 $(cat %s/run/%s.pid); ', ...
%!                    '(sleep %d; %s) > /dev/null 2>&1 &'], ...
%!                   cluster, daemon, seconds, start));
%!endfunction

%!function liftLimits (folder)
%!  files = glob (fullfile (folder, 'optim', 'First', '0*', 'limit'));
%!  cellfun (@(f) writeAtomic (f, "9999\n"), files);
%!endfunction

%!function listen (state, said, folder, cluster)
%!  said([state.message, ' ']) = true;
%!  slurmTestOnce (state, 2, folder, @() strike (cluster));
%!endfunction

%!function strike (cluster)
%!  pause (8);
%!  interrupt (cluster, 'slurmctld', 25);
%!endfunction

%!testif ; soakReady ()
%! setenv ('SLURM_TEST_NODE_TIMEOUT', '10');
%! cluster = slurmTestUp (4);

% Octave killed 40 times at random moments: every run was started once, and the
% results are those of an undisturbed plan
%!testif ; soakReady ()
%! rand ('twister', 1);
%! folder = fullfile (home, 'kills');
%! a = 1 + (1:60) / 64;
%! for k = 1:40
%!   pid = slurmTestStart (folder, a, 5);
%!   pause (1 + 4 * rand ());
%!   kill (pid, 9);
%! end
%! [Case, jobs] = slurmTestCase (folder, a, 5);
%! Case.options.executor = 'slurm';
%! r = runJobs (jobs, Case, @(s) []);
%! assert ({r.status}, repmat ({'ok'}, 1, 60));
%! assert (slurmTestStarts (folder), 60);
%! [Case, jobs] = slurmTestCase (fullfile (home, 'still'), a, 0);
%! q = executeLocal (jobs, Case, @(s) []);
%! assert ({r.results}, {q.results});

% the node is lost while runs are under way: records, and runJobs cures them
%!testif ; soakReady ()
%! folder = fullfile (home, 'lost');
%! [Case, jobs] = slurmTestCase (folder, 1:2, 50);
%! r = slurmExecutor ().execute (jobs, Case, ...
%!   @(s) slurmTestOnce (s, 2, folder, ...
%!                        @() interrupt (cluster, 'slurmd-n1', 45)));
%! assert ({r.status}, {'failed', 'failed'});
%! assert ({r.cause}, {'killed', 'killed'});
%! assert (! isempty (strfind (r(1).message, 'NODE_FAIL')));
%! Case.options.executor = 'slurm';
%! r = runJobs (jobs, Case, @(s) []);
%! assert ({r.status}, {'ok', 'ok'});

% the controller is killed and away for a while: waited for, nothing is lost
%!testif ; soakReady ()
%! folder = fullfile (home, 'away');
%! [Case, jobs] = slurmTestCase (folder, 1:6, 12);
%! said = containers.Map ();
%! r = slurmExecutor ().execute (jobs, Case, ...
%!   @(s) listen (s, said, folder, cluster));
%! assert ({r.status}, repmat ({'ok'}, 1, 6));
%! assert (slurmTestStarts (folder), 6);
%! assert (any (strncmp (said.keys (), 'Slurm does not answer', 21)));

% Slurm's own time limit, where the guard's was lifted
%!testif ; soakReady ()
%! folder = fullfile (home, 'limit');
%! [Case, jobs] = slurmTestCase (folder, [8, 1], 0);
%! Case.options.slurm.time = 1;
%! r = slurmExecutor ().execute (jobs, Case, ...
%!   @(s) slurmTestOnce (s, 1, folder, ...
%!                                          @() liftLimits (folder)));
%! assert ({r.status}, {'timeout', 'ok'});
%! assert (! isempty (strfind (r(1).message, 'TIMEOUT')));

% preempted by a job of a partition that goes first
%!testif ; soakReady ()
%! folder = fullfile (home, 'preempted');
%! [Case, jobs] = slurmTestCase (folder, 1:2, 20);
%! order = ['sbatch --partition=urgent --exclusive --time=5 ', ...
%!          '--output=/dev/null --wrap="sleep 5" > /dev/null'];
%! r = slurmExecutor ().execute (jobs, Case, ...
%!   @(s) slurmTestOnce (s, 2, folder, ...
%!                                              @() system (order)));
%! assert ({r.status}, {'failed', 'failed'});
%! assert ({r.cause}, {'killed', 'killed'});
%! assert (! isempty (strfind (r(1).message, 'PREEMPTED')));

% with as many sets at once the whole program gives the same calibration, to the
% last digit
%!testif ; soakReady ()
%! found = cell (1, 2);
%! for k = 1:2
%!   executor = {'local', 'slurm'}{k};
%!   folder = fullfile (home, ['whole-', executor]);
%!   standInCase (folder);
%!   writeLoadInput (folder, ...
%!     sprintf (['Input.executor = ''%s''; ', ...
%!               'Input.slurm = struct (''poll'', 0.5, ''sets'', 2);'], ...
%!              executor));
%!   [status, out, err] = startProgram (folder);
%!   assert (status == 0, '%s', [out, err]);
%!   file = fullfile (folder, 'results', 'calibration.json');
%!   found{k} = jsondecode (fileread (file));
%! end
%! assert (found{1}.params, found{2}.params);
%! assert (found{1}.targets, found{2}.targets);

%!testif ; soakReady ()
%! slurmTestDown (cluster);
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (home, 's');
%! setenv ('SLURM_CONF', config);
%! unsetenv ('SLURM_TEST_NODE_TIMEOUT');

% SPDX-License-Identifier: GPL-3.0-only
