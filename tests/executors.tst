% One plan of stand-in runs, some of which fail, through every executor that is
% there: the records must be the same, whoever made them.

%!function [records, text] = commonPlan (name, options)
%!  folder = fullfile (tempname (), 'it''s %a 1');
%!  mkdir (fileparts (folder));
%!  [Case, jobs] = slurmTestCase (folder, [1, 2, 9, 7, 8, 3.3], 0);
%!  Case.models.timeout = 3;
%!  Case.options.executor = name;
%!  Case.options.(name) = options;
%!  records = runJobs (jobs, Case, @(s) []);
%!  fields = {'model', 'stage', 'planRow', 'params', 'replicate', 'seed', ...
%!            'key', 'status', 'cause', 'results', 'funs'};
%!  text = cellfun (@(f) jsonencode ({records.(f)}), fields, ...
%!                  'UniformOutput', false);
%!  none = {Case.store, folder};
%!  confirm_recursive_rmdir (false, 'local');
%!  rmdir (folder, 's');
%!endfunction

%!shared r, expected, quick
%! [r, expected] = commonPlan ('local', struct ());
%! quick = struct ('poll', 0.4, 'grace', 2, 'sets', 3, 'before', ...
%!                 {{'export WHERE="a queue"'}});

%!test
%! % what the plan must give
%! assert ({r.status}, {'ok', 'ok', 'failed', 'invalid', 'timeout', 'ok'});
%! assert ({r.cause}, {'', '', 'exit', 'none', 'time', ''});
%! assert (r(6).results, [3.3 + 2, 3.3 * 2], 1e-12);
%! assert (! isempty (strfind (r(3).message, 'too dense')));

%!test
%! % every executor has its turn here: a new one needs a block of its own
%! assert (sort (executorNames ()), ...
%!         {'gridengine', 'local', 'slurm', 'static'});

%!test
%! [~, text] = commonPlan ('static', struct ());
%! assert (text, expected);

%!testif ; slurmTestReady ()
%! config = getenv ('SLURM_CONF');
%! cluster = slurmTestUp (8);
%! tidy = onCleanup (@() slurmTestDown (cluster));
%! [~, text] = commonPlan ('slurm', quick);
%! setenv ('SLURM_CONF', config);
%! assert (text, expected);

%!function tidy = gridengineUp (slots)
%!  % a cluster of one host, until TIDY is cleared
%!  folder = tempname (P_tmpdir (), 'sge-');
%!  here = fileparts (which ('slurmTestUp'));
%!  up = shellQuote (fullfile (here, 'gridengine-up.sh'));
%!  command = sprintf (['export GRIDENGINE_TEST_SLOTS=%d; %s %s %d 2>&1 ' ...
%!                      '&& . %s/settings.sh && ' ...
%!                      'env | grep -E "^(SGE_|PATH=)"'], ...
%!                     slots, up, folder, getpid (), folder);
%!  [status, text] = system (command);
%!  assert (status == 0, text);
%!  path = getenv ('PATH');
%!  tidy = onCleanup (@() gridengineDown (here, folder, path));
%!  settings = regexp (text, '^(\w+)=(.*)$', 'tokens', 'lineanchors', ...
%!                     'dotexceptnewline');
%!  for k = 1:numel (settings)
%!    setenv (settings{k}{:});
%!  end
%!endfunction

%!function gridengineDown (here, folder, path)
%!  system ([shellQuote(fullfile (here, 'gridengine-down.sh')), ' ', folder]);
%!  confirm_recursive_rmdir (false, 'local');
%!  rmdir (folder, 's');
%!  cellfun (@unsetenv, {'SGE_ROOT', 'SGE_CELL', 'SGE_QMASTER_PORT', ...
%!                       'SGE_EXECD_PORT'});
%!  setenv ('PATH', path);
%!endfunction

%!function ready = gridengineReady ()
%!  % with CI=true in the environment it is a failure where the daemons do not
%!  % start
%!  programs = {'sge_qmaster', 'sge_execd', 'qsub'};
%!  isThere = @(p) isfile (fullfile ('/usr/lib/gridengine', p));
%!  why = '';
%!  if ~all (cellfun (isThere, programs))
%!    why = ['apt-get install gridengine-master gridengine-exec ', ...
%!           'gridengine-client'];
%!  elseif getuid () ~= 0
%!    why = 'a test cluster can be started by root only';
%!  elseif isempty (getenv ('CI'))
%!    try
%!      tidy = gridengineUp (1);
%!    catch
%!      why = 'its daemons do not come up on this machine';
%!    end
%!  end
%!  ready = isempty (why);
%!  if ~ready
%!    printf ('tests with Grid Engine are skipped: %s\n', why);
%!  end
%!endfunction

%!testif ; gridengineReady ()
%! tidy = gridengineUp (8);
%! [~, text] = commonPlan ('gridengine', quick);
%! assert (text, expected);

%!function [Case, jobs] = localPlan (cpu, maxCPU, n)
%!  raw = standInCase (tempname ());
%!  raw.Input.cpu = cpu;
%!  raw.Input.maxCPU = maxCPU;
%!  Case = newCase (raw);
%!  jobs = newJobs (Case, (1:n)' * [1, 2], [], 1, 'plan');
%!endfunction

%!test
%! % every run is prepared, started and evaluated in workers of parcellfun
%! [Case, jobs] = localPlan ([1, 2], 4, 6);
%! profile ('on');
%! records = runJobs (jobs, Case, @(s) []);
%! profile ('off');
%! here = {profile('info').FunctionTable.FunctionName};
%! assert (all (ismember ({'executeLocal', 'parcellfun'}, here)));
%! away = {'carryRun', 'prepareRun', 'startRun', 'judgeRun', 'evaluateRun'};
%! assert (! any (ismember (away, here)));
%! assert ({records.status}, repmat ({'ok'}, 1, 12));
%! assert (numel (unique ({records.folder})), 12);

%!test
%! % CPUs of all runs under way are at most maxCPU, and as many as fit are taken
%! Case = localPlan ([2, 3], 7, 6);
%! for k = 1:2
%!   file = fullfile (Case.models(k).folder, 'runscript');
%!   writeAtomic (file, ["touch ../../on.$DECALIOC_CPU.$$\n", ...
%!     "ls ../.. | awk -F. '/^on/ { n += $2 } END { print n }' ", ...
%!     ">> ../../sum\nsleep 0.7\n", fileread(file), ...
%!     "rm ../../on.$DECALIOC_CPU.$$\n"]);
%! end
%! records = runJobs (newJobs (Case, (1:6)' * [1, 2], [], 1, 'plan'), Case, ...
%!                    @(s) []);
%! assert ({records.status}, repmat ({'ok'}, 1, 12));
%! assert (max (load (fullfile (Case.store, 'optim', 'sum'))) <= 7);
%! assert (max (load (fullfile (Case.store, 'optim', 'sum'))) >= 5);

%!test
%! % a getResults that ends its Octave or throws costs nobody else a record
%! [Case, jobs] = localPlan ([1, 1], 4, 4);
%! funs = fullfile (Case.models(2).folder, 'OctaveFuns', 'getResults.m');
%! writeAtomic (funs, ["function res = getResults (model, name)\n", ...
%!   "global path\nn = str2double (name(1:4));\n", ...
%!   "if n == 2\n  exit (3);\nelseif n == 3\n  error ('mine');\nend\n", ...
%!   "cd ('/');\nres = {n};\nend\n"]);
%! records = executeLocal (jobs, Case, @(s) []);
%! assert ({records.status}, {'ok', 'ok', 'ok', 'invalid', 'ok', 'invalid', ...
%!                            'ok', 'ok'});
%! assert (! isempty (strfind (records(4).message, 'ended the Octave')));
%! assert (! isempty (strfind (records(6).message, 'mine')));

%!testif ; ! isempty (file_in_path (getenv ('PATH'), 'mpirun'))
%! % ranks of concurrent MPI runs may use all cores
%! Case = localPlan ([1, 1], 4, 1);
%! writeAtomic (fullfile (Case.models(2).folder, 'runscript'), ...
%!   ["mpirun --oversubscribe -np 2 grep Cpus_allowed_list ", ...
%!    "/proc/self/status\necho 1 > out\n"]);
%! [~, all] = system ('grep Cpus_allowed_list /proc/self/status');
%! jobs = newJobs (Case, [1, 2; 3, 4], [], 1, 'plan')([2, 4]);
%! records = executeLocal (jobs, Case, @(s) []);
%! for k = 1:2
%!   text = fileread (fullfile (records(k).folder, 'stdout.txt'));
%!   assert (text, [all, all]);
%! end

% SPDX-License-Identifier: GPL-3.0-only
