% SLURMOVERHEAD  What a run costs beside its simulation when Slurm does it.
%
% CALL: octave-cli benchmarks/slurmOverhead.m [N ...]
%
%   N  numbers of runs to try (default 10 100 1000 5000, the last takes long)
%
% Starts a Slurm of its own (root, packages slurm-wlm and munge) whose one node
% pretends to have 64 processors, so that not the two or so real ones set the
% pace but the scheduler: the runs are a line of awk, nearly empty. Each plan is
% run by runJobs, as in a calibration; then an array of as many tasks of
% `true` is sent to the same Slurm without this toolbox, in parts of the same
% size. The difference is the toolbox.
%
% Prints a table and writes benchmarks/results/slurmOverhead.csv. Columns:
%   runs, ok     runs asked for, runs with a result
%   wall         time of runJobs (s); per_run: the same for one run
%   slurm        time of the bare arrays (s); slurm_run: the same for one task
%   octave_run   CPU time of the submitting Octave for one run (s)
%   resume       time of the same runJobs again, all taken from the store (s)
%   MB           highest memory of the submitting Octave so far

1;

function rows = measure (sizes, home)
  rows = zeros (0, 9);
  for n = sizes
    [Case, jobs] = slurmTestCase (fullfile (home, sprintf ('n%d', n)), ...
                                  linspace (10, 20, n), 0);
    Case.options.executor = 'slurm';
    Case.options.slurm = struct ('poll', 1, 'grace', 10, ...
                                 'maxInFlight', 1000);
    cpu = cputime ();
    watch = tic ();
    records = runJobs (jobs, Case, @(state) []);
    wall = toc (watch);
    cpu = cputime () - cpu;
    ok = sum (strcmp ({records.status}, 'ok'));
    watch = tic ();
    again = runJobs (jobs, Case, @(state) []);
    resume = toc (watch);
    assert ({again.results}, {records.results});
    alone = rawArrays (n, 1000, home);
    rows(end + 1, :) = [n, ok, wall, wall / n, alone, alone / n, ...
                        cpu / n, resume, memoryPeak()];
    printf ('%7d %6d %9.1f %9.4f %9.1f %9.4f %9.4f %9.2f %9.0f\n', ...
            rows(end, :));
    fflush (stdout ());
  end
end

% Time (s) that Slurm takes for n tasks of true, in arrays of at most k.
function seconds = rawArrays (n, k, home)
  watch = tic ();
  for first = 1:k:n
    system (sprintf (['cd %s && sbatch --parsable --wait --ntasks=1 ', ...
                      '--time=5 --output=/dev/null --array=1-%d ', ...
                      '--wrap=true > /dev/null'], home, ...
                     min (k, n - first + 1)));
  end
  seconds = toc (watch);
end

% Highest memory of this Octave so far (MB).
function mb = memoryPeak ()
  text = fileread ('/proc/self/status');
  mb = sscanf (regexp (text, 'VmHWM:\s*\d+', 'match', 'once'), ...
               'VmHWM: %d') / 1024;
end

function text = describeMachine ()
  [~, cpu] = system ('sed -n "s/^model name.*: //p" /proc/cpuinfo | head -n 1');
  [~, slurm] = system ('sinfo --version');
  load = sscanf (fileread ('/proc/loadavg'), '%f', 1);
  text = sprintf ('%d x %s (load %.1f), %s, Octave %s, %s', nproc (), ...
                  strtrim (cpu), load, strtrim (slurm), version (), ...
                  datestr (now (), 29));
end

history_save (false);
addpath (fileparts (mfilename ('fullpath')));
root = startBenchmarks ();
sizes = cellfun (@str2double, argv ()');
if isempty (sizes)
  sizes = [10, 100, 1000, 5000];
end
if ~slurmTestReady ()
  exit (1);
end
cluster = slurmTestUp (64);
machine = describeMachine ();
home = tempname ();
mkdir (home);
names = {'runs', 'ok', 'wall', 'per_run', 'slurm', 'slurm_run', ...
         'octave_run', 'resume', 'MB'};
printf ('%s\n', machine);
printf ('seconds; node of 64 declared processors, poll 1, maxInFlight 1000\n');
printf ('%7s %6s %9s %9s %9s %9s %9s %9s %9s\n', names{:});
table = measure (sizes, home);
file = fullfile (root, 'benchmarks', 'results', 'slurmOverhead.csv');
command = strtrim (sprintf ('octave-cli benchmarks/slurmOverhead.m%s', ...
                            sprintf (' %d', sizes)));
lines = sprintf ('%d,%d,%.2f,%.5f,%.2f,%.5f,%.5f,%.3f,%.0f\n', table');
writeAtomic (file, sprintf ('# %s\n# %s\n# %s\n%s\n%s', ...
                            machine, command, ...
                            ['64 declared processors, poll 1 s, ' ...
                             'maxInFlight 1000, MaxArraySize 2001'], ...
                            strjoin (names, ','), lines));
slurmTestDown (cluster);
confirm_recursive_rmdir (false);
rmdir (home, 's');
