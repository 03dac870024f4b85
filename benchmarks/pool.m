% POOL  What the local executor costs, in this and in other checkouts.
%
% CALL: octave-cli benchmarks/pool.m [LENGTH] [FOLDER]...
%
%   LENGTH  length of the runs of all but the makespan (s, default 12)
%   FOLDER  other checkouts of the toolbox (for instance of an earlier commit);
%           each question is put to all of them in turn, twice
%
% Stand-in runs that sleep. The questions:
%   makespan over its bound, for 2, 4 and 8 runs at a time (24 runs)
%   what a killed worker costs: starts of 4 runs, makespan, records that are ok
%   how long the program lives on after TERM, and after INT (Ctrl-C)
%   processor time of all Octaves for a run
% Each answer comes from a fresh Octave. The bound is max (total work / runs at
% a time, longest run), both from the records. Prints a table of the means and
% writes benchmarks/results/pool.csv.
%
% See also: executeLocal, makespan

1;

function [Case, jobs] = sleepers (lengths, atATime)
  folder = fullfile (pwd (), 'case');
  raw = standInCase (folder);
  raw.Input.model = {'First'};
  raw.Input.cpu = 1;
  raw.Input.maxCPU = atATime;
  raw.optim.targetVal = raw.optim.targetVal(1);
  raw.optim.tolRes = raw.optim.tolRes(1);
  writeAtomic (fullfile (folder, 'DEMmodels', 'First', 'runscript'), ...
               ["echo x >> ../starts\nset -- ", sprintf('%.3f ', lengths), ...
                "\nn=$(cat ExPlan.txt)\nsleep ${!n}\n", ...
                "echo 1 > out\necho 2 >> out\n"]);
  Case = newCase (raw);
  jobs = newJobs (Case, [lengths(:), lengths(:)], [], 1, 'plan');
end

function values = makespanOf (atATime)
  rand ('twister', atATime);
  [Case, jobs] = sleepers (0.5 * 10.^rand (24, 1), atATime);
  start = tic ();
  work = [executeLocal(jobs, Case, @(s) []).seconds];
  values = toc (start) / max (sum (work) / atATime, max (work));
end

% Three runs of one length and one of twice that, two at a time; a worker, if
% there is one, is killed in the first third.
function values = killWorker (span)
  system (sprintf (['(sleep %g; pgrep -P %d octave | head -n 1 | xargs ', ...
                    'kill -9) > /dev/null 2>&1 &'], span / 3, getpid ()));
  [Case, jobs] = sleepers (span * [1, 2, 1, 1], 2);
  start = tic ();
  records = executeLocal (jobs, Case, @(s) []);
  starts = fileread (fullfile ('case', 'optim', 'First', 'starts'));
  values = [sum(starts == 'x'), toc(start), ...
            sum(strcmp ({records.status}, 'ok'))];
end

% Of this process and its children, of which all but workers have a session of
% their own.
function values = processorTime (span)
  before = cputime ();
  [Case, jobs] = sleepers (span * ones (1, 4), 2);
  executeLocal (jobs, Case, @(s) []);
  values = cputime () - before;
  [~, pids] = system (sprintf ('pgrep -P %d octave', getpid ()));
  for pid = sscanf (pids, '%d')'
    stat = regexprep (fileread (sprintf ('/proc/%d/stat', pid)), '^.*\)', '');
    fields = strsplit (strtrim (stat), ' ');
    values = values + sum (str2double (fields(12:13))) / 100;
  end
  values = values / 4;
end

% Seconds that an Octave lives on after a signal to it alone, with two runs
% under way that have just begun; then how many are under way 3 s later.
function values = afterSignal (root, signal, span)
  [pid, folder] = startChild (root, 'sleep', span);
  marks = fullfile (folder, 'case', 'optim', 'First', '*', 'pid');
  while numel (glob (marks)) < 2 && ~isempty (processStart (pid))
    pause (0.1);
  end
  kill (pid, signal);
  start = tic ();
  while ~isempty (processStart (pid)) && toc (start) < 3 * span
    pause (0.02);
  end
  values = toc (start);
  kill (pid, 9);
  pause (3);
  guards = cellfun (@(f) sscanf (fileread (f), '%d', 1), glob (marks));
  values(2) = sum (arrayfun (@(p) ~isempty (processStart (p)), guards));
end

function [pid, folder] = startChild (root, question, number)
  folder = tempname ();
  mkdir (folder);
  script = [mfilename('fullpath'), '.m'];
  [~, pid] = system (sprintf (['cd %s && DECALIOC_POOL=%s setsid ', ...
                               'octave-cli --no-history %s %s %g > log ', ...
                               '2>&1 < /dev/null & echo $!'], folder, ...
                              shellQuote (root), shellQuote (script), ...
                              question, number));
  pid = str2double (pid);
end

function values = ask (root, question, number)
  if strcmp (question, 'signal')
    values = afterSignal (root, number(1), number(2));
    return
  end
  [pid, folder] = startChild (root, question, number);
  while ~isempty (processStart (pid))
    pause (0.1);
  end
  values = load (fullfile (folder, 'values'));
end

function answer (root, question, number)
  addpath (fullfile (root, 'infrastructure'), fullfile (root, 'tests'));
  startToolbox (root);
  switch question
    case 'makespan'
      values = makespanOf (number);
    case 'kill'
      values = killWorker (number);
    case 'time'
      values = processorTime (number);
    case 'sleep'
      [Case, jobs] = sleepers (number * [1, 1, 1], 2);
      executeLocal (jobs, Case, @(s) []);
      values = [];
  end
  save ('-ascii', 'values', 'values');
end

history_save (false);
words = argv ();
if ~isempty (getenv ('DECALIOC_POOL'))
  answer (getenv ('DECALIOC_POOL'), words{end - 1}, str2double (words{end}));
  exit (0);
end
addpath (fileparts (mfilename ('fullpath')));
root = startBenchmarks ();
words = words(~strncmp (words, '-', 1) & ~strcmp (words, program_name ()));
words = words(cellfun (@isempty, strfind (words, 'pool.m')));
span = 12;
if ~isempty (words) && ~isnan (str2double (words{1}))
  span = str2double (words{1});
  words(1) = [];
end
roots = [{root}, words(:)'];
questions = {'makespan', 2, {'makespan / bound, 2 at a time'}
             'makespan', 4, {'4 at a time'}
             'makespan', 8, {'8 at a time'}
             'kill', span, {'killed worker: starts of 4 runs', ...
                            'the same: makespan (s)', 'the same: records ok'}
             'signal', [15, span], {'lives on after TERM (s)', 'runs left over'}
             'signal', [2, span], {'lives on after INT (s)', 'runs left over'}
             'time', span, {'Octave''s processor time, a run (s)'}};
table = [];
printf ('| |%s\n|---|%s\n', sprintf (' %s |', roots{:}), ...
        repmat ('---|', 1, numel (roots)));
for q = 1:rows (questions)
  values = zeros (2, numel (questions{q, 3}), numel (roots));
  for k = 1:2
    for r = 1:numel (roots)
      values(k, :, r) = ask (roots{r}, questions{q, 1:2});
    end
  end
  values = reshape (mean (values, 1), numel (questions{q, 3}), numel (roots));
  for i = 1:rows (values)
    printf ('| %s |%s\n', questions{q, 3}{i}, ...
            sprintf (' %.2f |', values(i, :)));
    fflush (stdout ());
  end
  table = [table; values];
end
names = arrayfun (@(k) sprintf ('checkout%d', k), 1:numel (roots), ...
                  'UniformOutput', false);
writeMatrix (fullfile (root, 'benchmarks', 'results', 'pool.csv'), table, ...
             names);
