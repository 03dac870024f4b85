% POOL  Runs in workers of parcellfun against the local executor.
%
% CALL: octave-cli benchmarks/pool/pool.m [LENGTH] [noMakespan]
%
% LENGTH      length of the runs after the first table (s, default 12)
% noMakespan  leaves the first table out
%
% Stand-in runs that sleep. Four questions, each put to poolPlan (one run a
% worker of parcellfun) and to executeLocal:
%   makespan over its bound, for 2, 4 and 8 runs at a time
%   what a worker killed with signal 9 costs: starts of runs, makespan
%   how long the program lives on after TERM, and after INT (Ctrl-C)
%   processor time of all Octaves for a run
% Prints tables and writes benchmarks/results/pool.csv.
%
% See also: poolPlan, executeLocal, makespan

1;

function [Case, jobs] = sleepers (folder, lengths, workers)
  raw = standInCase (folder);
  raw.Input.model = {'First'};
  raw.Input.cpu = 1;
  raw.Input.maxCPU = workers;
  raw.optim.targetVal = raw.optim.targetVal(1);
  raw.optim.tolRes = raw.optim.tolRes(1);
  writeAtomic (fullfile (folder, 'DEMmodels', 'First', 'runscript'), ...
               ["echo x >> ../starts\nset -- ", sprintf('%.3f ', lengths), ...
                "\nn=$(cat ExPlan.txt)\nsleep ${!n}\n", ...
                "echo 1 > out\necho 2 >> out\n"]);
  Case = newCase (raw);
  jobs = newJobs (Case, [lengths(:), lengths(:)], [], 1, 'plan');
end

function [seconds, records, folder] = carryOut (how, lengths, workers)
  folder = tempname ();
  [Case, jobs] = sleepers (folder, lengths, workers);
  start = tic ();
  if strcmp (how, 'pool')
    records = poolPlan (jobs, Case, @(s) []);
  else
    records = executeLocal (jobs, Case, @(s) []);
  end
  seconds = toc (start);
end

function row = makespans (workers)
  rand ('twister', workers);
  lengths = 0.5 * 10.^rand (24, 1);
  row = workers;
  for how = {'pool', 'local'}
    [seconds, records] = carryOut (how{1}, lengths, workers);
    work = [records.seconds];
    row(end + 1) = seconds / max (sum (work) / workers, max (work));
  end
end

% Three runs of one length and one of twice that, two at a time; the worker (or
% of the local executor the guard) of the first is killed in its first third.
function row = afterKill (how, span)
  deed = ['pgrep -P %d octave | head -n 1 | xargs kill -9'];
  if strcmp (how, 'local')
    deed = ['pgrep -f "guard.sh /.* %d" | head -n 1 | xargs kill -9'];
  end
  system (sprintf (['(sleep %g; ', deed, ') 2> /dev/null &'], span / 3, ...
                   getpid ()));
  [seconds, records, folder] = carryOut (how, span * [1, 2, 1, 1], 2);
  starts = fileread (fullfile (folder, 'optim', 'First', 'starts'));
  row = [sum(starts == 'x'), seconds, sum(strcmp ({records.status}, 'ok'))];
end

% Seconds that an Octave lives on after a signal to it alone, with runs under
% way that have just begun.
function seconds = afterSignal (how, signal, span)
  folder = tempname ();
  mkdir (folder);
  script = [mfilename('fullpath'), '.m'];
  [~, pid] = system (sprintf (['cd %s && DECALIOC_POOL=%s setsid ', ...
                               'octave-cli --no-history %s %g > log 2>&1 ', ...
                               '& echo $!'], ...
                              folder, how, shellQuote (script), span));
  pid = str2double (pid);
  while numel (glob (fullfile (folder, 'case', 'optim', 'First', '*', ...
                               'pid'))) < 2 && ~isempty (processStart (pid))
    pause (0.1);
  end
  kill (pid, signal);
  start = tic ();
  while ~isempty (processStart (pid)) && toc (start) < 3 * span
    pause (0.05);
  end
  seconds = toc (start);
  kill (pid, 9);
end

function seconds = octaveTime (how, span)
  parcellfun_set_nproc (0);
  before = cputime ();
  carryOut (how, span * ones (1, 4), 2);
  seconds = cputime () - before;
  [~, pids] = system (sprintf ('pgrep -P %d octave', getpid ()));
  for pid = sscanf (pids, '%d')'
    stat = regexprep (fileread (sprintf ('/proc/%d/stat', pid)), '^.*\)', '');
    fields = strsplit (strtrim (stat), ' ');
    seconds = seconds + sum (str2double (fields(12:13))) / 100;
  end
  seconds = seconds / 4;
end

history_save (false);
addpath (fileparts (fileparts (mfilename ('fullpath'))));
root = startBenchmarks ();
span = 12;
words = argv ();
numbers = str2double (words);
if any (~isnan (numbers))
  span = numbers(find (~isnan (numbers), 1, 'last'));
end
if ~isempty (getenv ('DECALIOC_POOL'))       % the child of afterSignal
  [Case, jobs] = sleepers (fullfile (pwd (), 'case'), span * [1, 1, 1], 2);
  how = struct ('pool', @poolPlan, 'local', @executeLocal);
  how.(getenv ('DECALIOC_POOL')) (jobs, Case, @(s) []);
  exit (0);
end
table = zeros (0, 3);
printf ('| makespan / bound, runs at a time | pool | local |\n|---|---|---|\n');
atATime = [2, 4, 8];
if any (strcmp (words, 'noMakespan'))
  atATime = [];
end
for workers = atATime
  table(end + 1, :) = makespans (workers);
  printf ('| %d | %.2f | %.2f |\n', table(end, :));
end
pool = [afterKill('pool', span), afterSignal('pool', 15, span), ...
        afterSignal('pool', 2, span), octaveTime('pool', span)];
local = [afterKill('local', span), afterSignal('local', 15, span), ...
         afterSignal('local', 2, span), octaveTime('local', span)];
texts = {'killed worker or guard: starts of 4 runs', ...
         'the same: makespan (s)', 'the same: records ok', ...
         'lives on after TERM (s)', 'lives on after INT (s)', ...
         'Octave''s processor time, a run (s)'};
printf ('\n| runs of %g s | pool | local |\n|---|---|---|\n', span);
for k = 1:numel (texts)
  printf ('| %s | %.2f | %.2f |\n', texts{k}, pool(k), local(k));
end
table = [table; zeros(numel (pool), 1), pool', local'];
writeMatrix (fullfile (root, 'benchmarks', 'results', 'pool.csv'), table, ...
             {'atATime', 'pool', 'local'});
