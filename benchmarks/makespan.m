% MAKESPAN  How long a plan of uneven runs takes, dynamic and published split.
%
% CALL: octave-cli benchmarks/makespan.m [REPETITIONS]
%
% A plan of 24 stand-in runs that sleep between 0.5 and 5 s (log-uniform, the
% lengths differ tenfold) on 2, 4 and 8 workers. The bound is max (total work /
% workers, longest run); the work of a run is what its own record says, so the
% cost of starting a run is in the makespan and not in the bound. Sleeping
% needs no core, so more workers than cores are fair. The published split is
% what SplitToCPU and SplitExPlan give, each stack one process, all at once.
% Prints a table and writes benchmarks/results/makespan.csv.

1;

function folder = unevenCase (lengths)
  folder = tempname ();
  standInCase (folder);
  model = fullfile (folder, 'DEMmodels', 'First');
  table = sprintf ('%.3f ', lengths);
  writeAtomic (fullfile (model, 'runscript'), ...
               ["set -- ", table, "\nn=$(cat ExPlan.txt)\nsleep ${!n}\n", ...
                "echo 1 > out\necho 2 >> out\n"]);
end

function [seconds, bound] = dynamicTime (lengths, workers)
  raw = rawOf (unevenCase (lengths), workers);
  Case = newCase (raw);
  jobs = newJobs (Case, [lengths, lengths], [], 1, 'plan');
  start = tic ();
  records = executeLocal (jobs, Case, @(s) []);
  seconds = toc (start);
  work = [records.seconds];
  bound = max (sum (work) / workers, max (work));
end

function seconds = staticTime (lengths, workers)
  [n, per, rest] = SplitToCPU (workers, numel (lengths), 1);
  [main, left] = SplitExPlan (lengths, n, per, rest);
  % parcellfun would cut the number of workers to that of the cores, so the
  % stacks are added up: the rest rows go to the processes that end first
  busy = cellfun (@(s) sum (s(:, 1)), main);
  for k = 1:numel (left)
    [~, first] = min (busy);
    busy(first) = busy(first) + left{k}(1);
  end
  seconds = max (busy);
end

function raw = rawOf (folder, workers)
  raw = struct ('root', fileparts (fileparts (which ('startToolbox'))), ...
                'folder', folder);
  raw.Input = struct ('model', {{'First'}}, 'cpu', 1, 'maxCPU', workers, ...
                      'numOfSam', 24);
  raw.optim = struct ('targetVal', {{[1, 2]}}, 'tolRes', {{[0.01, 0.01]}}, ...
                      'tolfun', 0.002, 'maxIter', 3, 'maxFunEvals', 40, ...
                      'WRL', 0);
  raw.modelVars = struct ();
  raw.assign = {'a', 'b'};
  raw.paramLims = [0, 0; 10, 10];
end

history_save (false);
addpath (fileparts (mfilename ('fullpath')));
root = startBenchmarks ();
repetitions = 5;
if ~isempty (argv ())
  repetitions = str2double (argv (){end});
end
table = [];
printf ('%8s %6s %9s %9s %12s %12s\n', 'workers', 'seed', 'bound (s)', ...
        'ours (s)', 'ours/bound', 'split/bound');
for workers = [2, 4, 8]
  for seed = 1:repetitions
    rand ('twister', seed);
    lengths = 0.5 * 10.^rand (24, 1);
    [seconds, bound] = dynamicTime (lengths, workers);
    split = staticTime (lengths, workers);
    splitBound = max (sum (lengths) / workers, max (lengths));
    table(end + 1, :) = [workers, seed, bound, seconds, seconds / bound, ...
                         split / splitBound];
    printf ('%8d %6d %9.2f %9.2f %12.3f %12.3f\n', table(end, :));
  end
end
[~, ~] = mkdir (fullfile (root, 'benchmarks', 'results'));
writeMatrix (fullfile (root, 'benchmarks', 'results', 'makespan.csv'), ...
             table, ...
             {'workers', 'seed', 'bound', 'ours', 'oursOverBound', ...
              'splitOverBound'});
for workers = [2, 4, 8]
  mine = table(table(:, 1) == workers, :);
  printf (['%d workers: ours/bound median %.3f, worst %.3f; ' ...
           'split/bound median %.3f, worst %.3f\n'], ...
          workers, median (mine(:, 5)), max (mine(:, 5)), ...
          median (mine(:, 6)), max (mine(:, 6)));
end
