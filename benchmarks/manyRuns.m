% MANYRUNS  Memory and resume time of the run engine on many short runs.
%
% CALL: octave-cli benchmarks/manyRuns.m [RUNS]
%
% RUNS (default 5000) stand-in runs of some milliseconds go through runJobs.
% The resident memory of Octave is read from /proc while they run. Then the
% store is resumed by a fresh Octave: how long until it has found all runs.
% Prints a table and writes benchmarks/results/manyRuns.csv.

1;

function mb = residentMemory ()
  text = fileread ('/proc/self/status');
  kb = regexp (text, 'VmRSS:\s+(\d+)', 'tokens', 'once'){1};
  mb = str2double (kb) / 1024;
end

function note (state, box)
  if state.done >= box('next')
    box('next') = box('next') + box('step');
    row = [state.done, state.seconds, residentMemory()];
    box('table') = [box('table'); row];
    printf ('%8d %10.1f %10.1f\n', row);
    fflush (stdout ());
  end
end

history_save (false);
addpath (fileparts (mfilename ('fullpath')));
root = startBenchmarks ();
n = 5000;
args = argv ();
if ~isempty (args) && ~isnan (str2double (args{end}))
  n = str2double (args{end});
end
folder = getenv ('DECALIOC_MANYRUNS');
isResume = ~isempty (folder);
if ~isResume
  folder = tempname ();
  standInCase (folder);
  setenv ('DECALIOC_MANYRUNS', folder);
end
raw = standInCase (tempname ());
raw.folder = folder;
raw.Input.model = {'First'};
raw.Input.cpu = 1;
raw.optim.targetVal = raw.optim.targetVal(1);
raw.optim.tolRes = raw.optim.tolRes(1);
Case = newCase (raw);
rand ('twister', 1);
jobs = newJobs (Case, 10 * rand (n, 2), [], 1, 'plan');
box = containers.Map ({'next', 'step', 'table'}, {n / 10, n / 10, []}, ...
                      'UniformValues', false);
start = tic ();
[records, isReused] = runJobs (jobs, Case, @(s) note (s, box));
seconds = toc (start);
if isResume
  printf ('resume: %d of %d runs found in %.2f s, memory %.1f MB\n', ...
          sum (isReused), n, seconds, residentMemory ());
else
  printf ('%d runs in %.0f s, %d ok\n', n, seconds, ...
          sum (strcmp ({records.status}, 'ok')));
  writeMatrix (fullfile (root, 'benchmarks', 'results', 'manyRuns.csv'), ...
               box('table'), {'runs', 'seconds', 'residentMB'});
  system (sprintf ('octave-cli --no-history %s %d', ...
                   shellQuote ([mfilename('fullpath'), '.m']), n));
end
