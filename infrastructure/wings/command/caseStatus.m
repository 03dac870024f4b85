% CASESTATUS  How far a calibration is, from the files of its case folder.
%
% CALL: S = caseStatus (CASE, COST)
%
%   CASE  see newCase
%   COST  cost function, see newProblem; []: the published residual
%   S     scalar struct:
%     holder   see lockHolder
%     state    'running', 'unknown' (the lock names another machine), 'stopped',
%              'finished' (a result, and no run begun after it), 'tried' (one set
%              at most has been run, by check --try), 'new'
%     stage    'plan', 'calibration', 'gap', or '' where there is no run
%     models   1 x M struct array: name, done, failed, running, waiting, lost
%              (broken off, see runsOfCase), old (runs that no longer count),
%              unread (done, but to be read anew at the next start), elapsed
%              (1 x n, seconds since each of these was started), seconds (median,
%              NaN: not known)
%     plan     1 x 2, runs of the plan that are done, and all of them
%     sets     1 x 2, sets run after the plan, and optim.maxFunEvals (which
%              counts a set once more for each repeat);  later  their runs
%     failures 1 x n cell of texts, what failed and why, each once, with the
%              number of runs
%     left     seconds until the plan (in the stage of the plan) or at most
%              until the end (later) of the calibration; NaN: not known
%     changed  see storedResult
%     best     see bestSet; verdict  see decideCase: of a result, once there
%              is one; set  1 x d, the set of results/calibration.json; []

function s = caseStatus (Case, cost)
  Case.hashes = hashModels (Case);
  runs = runsOfCase (Case);
  current = runs([runs.isCurrent]);
  f = foresee (Case, current);
  f.isDone = f.isDone | isReplaced (f.jobs, current);
  s.holder = lockHolder (Case.folder);
  s.stage = lastStage (runs);
  [stored, verdict] = storedResult (Case);
  s.state = stateOf (Case, s.holder, runs, stored);
  s.models = countsOf (Case, runs, f.seconds);
  s.plan = [sum(f.isDone), numel(f.isDone)];
  later = current(strcmp (stagesOf (current), 'calibration'));
  isPlanned = @(r) any (all (abs (r.job.params(:)' - f.plan) < ...
                             1e-12 * max (1, abs (f.plan)), 2));
  later = later(~arrayfun (isPlanned, later));
  s.later = numel (later);
  s.sets = [numberOfSets(later), Case.options.maxFunEvals];
  s.failures = failuresOf (current, Case);
  s.left = secondsLeft (s, f, Case);
  s.best = bestSet (Case, runs, cost);
  [s.verdict, s.set] = deal ([]);
  c = stored.calibration;
  s.changed = stored.changed;
  if strcmp (s.state, 'finished') && ...
     (isfield (c, 'reason') || isfield (stored.gap, 'which'))
    s.verdict = verdict ();
  end
  if ~isempty (s.verdict) && all (isfield (jsonAt (c, {'params'}), Case.names))
    s.set = cellfun (@(n) c.params.(n), Case.names);
  end
end

function stages = stagesOf (runs)
  stages = cellfun (@(j) j.stage, {runs.job}, 'UniformOutput', false);
end

% A run that failed is done once the one with another seed in its place is.
function yes = isReplaced (jobs, runs)
  runs = runs(ismember ({runs.state}, {'ok', 'ended'}));
  place = @(job) {job.model, job.params(:), job.effects(:), job.replicate};
  places = arrayfun (@(r) place (r.job), runs, 'UniformOutput', false);
  isIn = @(wanted) any (cellfun (@(p) isequal (p, wanted), places));
  yes = arrayfun (@(job) isIn (place (job)), jobs);
end

function n = numberOfSets (runs)
  sets = cellfun (@(j) toDigits (j.params(:)'), {runs.job}, ...
                  'UniformOutput', false);
  n = rows (unique (vertcat (sets{:}), 'rows'));
end

% A run that was asked for twice bears the first stage: the latest counts.
function stage = lastStage (runs)
  stage = '';
  stages = {'plan', 'calibration', 'calibration', 'gap', 'gap'};
  if ~isempty (runs)
    [~, rank] = ismember (stagesOf (runs), ...
                          {'plan', 'verify', 'calibration', 'cure', 'gap'});
    stage = stages{max(max (rank), 1)};
  end
end

function state = stateOf (Case, holder, runs, stored)
  states = struct ('alive', 'running', 'unknown', 'unknown', ...
                   'gone', 'stopped', 'none', 'stopped');
  state = states.(holder.state);
  if ~strcmp (state, 'stopped')
    return
  end
  if isWhole (Case, runs, stored)
    state = 'finished';
  elseif isempty (runs)
    state = 'new';
  elseif numberOfSets (runs) < 2 && ...
         ~isfile (fullfile (Case.folder, 'Octave_logfile.txt'))
    state = 'tried';
  end
end

% There is a result, and nothing was begun after it: by what the files say, as
% the times of a case that was copied or checked out are those of the copy.
function yes = isWhole (Case, runs, stored)
  hasResult = ~isempty (stored.calibration) || ~isempty (stored.gap);
  isOpen = isfile (fullfile (Case.folder, 'results', 'progress.json'));
  [~, names] = cellfun (@fileparts, {runs.folder}, 'UniformOutput', false);
  isLater = str2double (names) > stored.lastRuns([runs.model]);
  yes = hasResult && ~isOpen && ~any (isLater);
end

function models = countsOf (Case, runs, seconds)
  models = struct ('name', {Case.models.name}, 'seconds', num2cell (seconds));
  for k = 1:numel (models)
    ofModel = runs([runs.model] == k);
    current = ofModel([ofModel.isCurrent]);
    states = {current.state};
    count = @(varargin) sum (ismember (states, varargin));
    models(k).done = count ('ok', 'ended');
    models(k).unread = count ('ended');
    models(k).failed = count ('failed', 'timeout', 'invalid');
    models(k).lost = count ('lost');
    models(k).running = count ('running');
    models(k).elapsed = sinceStart (current(strcmp (states, 'running')));
    models(k).waiting = count ('waiting');
    models(k).old = sum (~[ofModel.isCurrent]);
  end
end

% Seconds since each of these was started: here, or by a task of a queue.
function seconds = sinceStart (runs)
  seconds = zeros (1, 0);
  for run = runs(:)'
    marks = cellfun (@stat, fullfile (run.folder, {'pid', 'batch.claim', 'job.json'}), ...
                     'UniformOutput', false);
    begun = [marks{:}];                   % none: the folder has gone meanwhile
    if ~isempty (begun)
      seconds(end + 1) = time () - begun(1).mtime;
    end
  end
end

function lines = failuresOf (runs, Case)
  bad = runs(ismember ({runs.state}, {'failed', 'timeout', 'invalid'}));
  words = arrayfun (@(r) sprintf ('%s: %s %s', Case.models(r.model).name, ...
                                  r.state, r.message), bad, ...
                    'UniformOutput', false);
  [lines, first, which] = unique (words);
  for i = 1:numel (lines)
    lines{i} = sprintf ('%d x %s (%s)', sum (which == i), ...
                        strtrim (lines{i}), bad(first(i)).folder);
  end
  lines = lines(:)';
end

% As many runs at a time as there are now or, on one machine, as CPUs allow.
function seconds = secondsLeft (s, f, Case)
  hours = f.mostHours;
  if strcmp (s.stage, 'plan') || isempty (s.stage)
    hours = f.planHours;
  elseif all (f.isDone)
    left = max (0, s.sets(2) - s.sets(1));
    hours = sum (f.seconds .* [Case.models.cpu]) / 3600 * left;
  end
  for k = 1:numel (s.models)              % of those under way a part is done
    hours = hours - Case.models(k).cpu / 3600 * ...
            sum (min (s.models(k).elapsed, f.seconds(k)));
  end
  hours(hours < 0) = 0;
  atATime = Case.options.maxCPU;
  if ~strcmp (Case.options.executor, 'local')
    atATime = max (1, sum ([s.models.running] .* [Case.models.cpu]));
  end
  seconds = hours * 3600 / atATime;
end

%!test
%! % new; in the middle of the plan, with a failure; finished
%! Case = readyCase ();
%! s = caseStatus (Case, []);
%! assert ({s.state, s.stage}, {'new', ''});
%! assert (s.plan, [0, 16]);
%! f = foresee (Case, runsOfCase (Case));
%! lock = lockCase (Case.folder);
%! runJobs (f.jobs(1:6), Case, @(state) []);
%! failedRecord (f.jobs(7), prepareRun (f.jobs(7), Case), 'timeout', ...
%!               'too slow', 'time');
%! s = caseStatus (Case, []);
%! assert ({s.state, s.stage}, {'running', 'plan'});
%! assert (s.plan, [6, 16]);
%! assert ([s.models.done], [3, 3]);
%! assert ([s.models.failed], [1, 0]);
%! assert ([s.models.elapsed], zeros (1, 0));
%! assert (numel (s.failures), 1);
%! assert (~isempty (strfind (s.failures{1}, 'too slow')));
%! seconds = [s.models.seconds];
%! assert (s.left, sum ([5, 5] .* seconds) / 2, 1e-9);
%! assert (s.best.runs, 1);
%! clear lock
%! assert (caseStatus (Case, []).state, 'stopped');
%! runJobs ([f.jobs(7:end), newJobs(Case, [1, 2], [], 1, 'calibration')], ...
%!          Case, @(state) []);
%! mkdir (fullfile (Case.folder, 'results'));
%! writeAtomic (fullfile (Case.folder, 'results', 'calibration.json'), '{}');
%! s = caseStatus (Case, []);
%! assert ({s.state, s.stage}, {'finished', 'calibration'});
%! assert (s.plan, [16, 16]);
%! assert (s.sets, [1, 40]);
%! assert (s.later, 2);
%!test
%! % how long the longest run has been going
%! Case = readyCase ();
%! jobs = foresee (Case, runsOfCase (Case)).jobs;
%! lock = lockCase (Case.folder);
%! folder = prepareRun (jobs(1), Case);
%! writeAtomic (fullfile (folder, 'pid'), ...
%!              sprintf ("%d 1 %s\n", getpid (), nthargout (2, @processStart, getpid ())));
%! system (['touch -d "-5 min" ', shellQuote(fullfile (folder, 'pid'))]);
%! s = caseStatus (Case, []);
%! k = strcmp ({Case.models.name}, jobs(1).model);
%! assert ([s.models.running], double (k));
%! assert (s.models(k).elapsed, 300, 60);
%! assert (isempty (s.models(~k).elapsed));
%! clear lock
%!test
%! % a plan of which one run failed and another seed took its place is done
%! raw = standInCase (tempname ());
%! Case = newCase (raw);
%! job = foresee (Case, runsOfCase (Case)).jobs(3);
%! k = find (strcmp (job.model, {Case.models.name}));
%! file = fullfile (Case.models(k).folder, 'runscript');
%! spoil = sprintf ('! grep -q "runSeed equal %d$" data.head', job.seed);
%! writeAtomic (file, [spoil, " || exit 1\n", fileread(file)]);
%! Case = newCase (raw);
%! f = foresee (Case, runsOfCase (Case));
%! lock = lockCase (Case.folder);
%! runJobs (f.jobs, Case, @(state) []);
%! s = caseStatus (Case, []);
%! assert (sum ([s.models.failed]), 1);
%! assert (s.plan, [16, 16]);
%! clear lock

% SPDX-License-Identifier: GPL-3.0-only
