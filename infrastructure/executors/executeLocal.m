% EXECUTELOCAL  Carries out runs on this machine.
%
% CALL: RECORDS = executeLocal (JOBS, CASE, REPORT)
%
%   JOBS     1 x n struct array, see newJobs
%   CASE     see newCase; CASE.options.maxCPU is shared by all models
%   REPORT   function handle, called with the state after each change
%   RECORDS  1 x n struct array, see newRecord
%
% A run starts as soon as its CPUs are free, those that need many CPUs first,
% so runs of uneven length keep all CPUs busy. Each simulation is a process of
% its own under guard.sh. When this function is left early (Ctrl-C, an error)
% the simulations under way are ended; when Octave is killed, the guards see
% it and end them. Without Input.timeout the time limit of a run is 20 times
% the median of the model's runs in this calibration, and at least 60 s.
%
% parcellfun is not used to start simulations: docs/method.md says why, with
% figures. The next run is prepared while others are under way, and started
% before ended ones are evaluated, so a CPU waits for little more than the next
% look (lookAfter). A look is one stat a run: isfile costs twenty times as much.
%
% See also: runJobs, executeSlurm, lookAfter, startRun

function records = executeLocal (jobs, Case, report)
  n = numel (jobs);
  cpus = arrayfun (@(j) cpuOf (j, Case), jobs);
  [~, queue] = sort (-cpus);
  folders = cell (1, n);
  marksOf = cell (1, n);
  born = zeros (1, n);
  records = repmat (newRecord (jobs(1), ''), 1, n);
  isDone = false (1, n);
  running = [];
  live = containers.Map ();
  tidy = onCleanup (@() cellfun (@endRun, live.keys ()));
  start = tic ();
  guardsSeen = 0;
  usual = NaN (1, n);
  while ~all (isDone)
    now = toc (start);
    age = now - born(running);
    marks = cellfun (@stat, marksOf(running), 'UniformOutput', false);
    hasEnded = ~cellfun ('isempty', marks);
    if now - guardsSeen > 2
      guardsSeen = now;
      hasEnded = hasEnded | cellfun (@isLost, folders(running), ...
                                     num2cell (age));
    end
    ended = running(hasEnded);
    running(hasEnded) = [];
    next = firstFitting (queue, cpus, ...
                         Case.options.maxCPU - sum (cpus(running)));
    while ~isempty (next)
      folders = prepareOnce (next, folders, jobs, Case);
      live(folders{next}) = next;
      marksOf{next} = fullfile (folders{next}, 'end.mark');
      startRun (folders{next}, Case.root);
      born(next) = toc (start);
      queue(queue == next) = [];
      running(end + 1) = next;
      next = firstFitting (queue, cpus, ...
                           Case.options.maxCPU - sum (cpus(running)));
    end
    if ~isempty (ended)
      records(ended) = collectEnded (jobs(ended), folders(ended), Case);
      isDone(ended) = true;
      live.remove (folders(ended));
      setLimits (records(isDone), jobs(running), folders(running), Case);
      queue = longestFirst (queue, cpus, jobs, records, isDone);
      usual = shortestOf (records(isDone), jobs);
      report (stateOf (records, isDone, running, toc (start)));
    elseif ~isempty (queue) && isempty (folders{queue(1)})
      folders = prepareOnce (queue(1), folders, jobs, Case);
    else
      pause (lookAfter (now - born(running), usual(running)));
    end
  end
end

function folders = prepareOnce (k, folders, jobs, Case)
  if isempty (folders{k})
    folders{k} = prepareRun (jobs(k), Case);
  end
end

% Long runs that start last keep all others waiting. How long a run will take
% is foreseen from the finished ones: log (seconds) linear in the parameters.
function queue = longestFirst (queue, cpus, jobs, records, isDone)
  enough = 200;
  if isempty (queue) || sum (isDone) > enough
    return
  end
  foreseen = zeros (1, numel (queue));
  for model = unique ({jobs(queue).model})
    isSame = isDone & strcmp ({jobs.model}, model{1}) & ...
             strcmp ({records.status}, 'ok') & [records.seconds] > 0;
    mine = find (strcmp ({jobs(queue).model}, model{1}));
    if sum (isSame) >= 4
      A = [ones(sum (isSame), 1), vertcat(jobs(isSame).params)];
      B = [ones(numel (mine), 1), vertcat(jobs(queue(mine)).params)];
      foreseen(mine) = B * (pinv (A) * log ([records(isSame).seconds])');
    end
  end
  [~, order] = sortrows ([-cpus(queue)', -foreseen', (1:numel (queue))']);
  queue = queue(order);
end

% Length of the shortest run so far of each job's model, NaN where none ended.
function seconds = shortestOf (done, jobs)
  seconds = NaN (1, numel (jobs));
  done = done(strcmp ({done.status}, 'ok'));
  for model = unique ({done.model})
    own = strcmp ({done.model}, model{1});
    seconds(strcmp ({jobs.model}, model{1})) = min ([done(own).seconds]);
  end
end

function n = cpuOf (job, Case)
  n = Case.models(strcmp (job.model, {Case.models.name})).cpu;
end

function next = firstFitting (queue, cpus, free)
  next = queue(find (cpus(queue) <= free, 1));
end

function yes = hasMark (folder)
  yes = isfile (fullfile (folder, 'end.mark'));
end

% A guard that is gone without an end mark was killed. One that has not shown
% up after half a minute never will (a full disk, no shell).
function yes = isLost (folder, age)
  [pids, isAlive] = runPids (folder);
  isGone = isempty (pids) && age > 30 || numel (pids) == 2 && ~isAlive;
  yes = isGone && ~hasMark (folder);
end

function records = collectEnded (jobs, folders, Case)
  isWhole = ~cellfun (@(f) isempty (readEndMark (f)), folders);
  records = repmat (newRecord (jobs(1), ''), 1, numel (jobs));
  if any (isWhole)
    records(isWhole) = collectRuns (jobs(isWhole), folders(isWhole), Case);
  end
  for i = find (~isWhole)
    endRun (folders{i});
    records(i) = failedRecord (jobs(i), folders{i}, 'failed', ...
                               'the guard of the run was killed', 'killed');
  end
end

% Runs under way get a limit once three runs of their model have ended well.
function setLimits (done, jobs, folders, Case)
  for i = 1:numel (jobs)
    k = strcmp (jobs(i).model, {Case.models.name});
    limit = defaultLimit (Case.models(k), done);
    file = fullfile (folders{i}, 'limit');
    if ~isnan (limit) && ~isfile (file)
      writeAtomic (file, sprintf ("%d\n", ceil (limit)), false);
    end
  end
end

function state = stateOf (records, isDone, running, seconds)
  status = {records(isDone).status};
  state = struct ('total', numel (isDone), 'done', sum (isDone), ...
                  'failed', sum (~strcmp (status, 'ok')), ...
                  'running', numel (running), 'seconds', seconds);
end

%!function Case = quickCase ()
%!  Case = newCase (standInCase (tempname ()));
%!  Case.options.maxCPU = 4;
%!endfunction
%!test
%! Case = quickCase ();
%! jobs = newJobs (Case, [1, 2; 3, 4], [], 1, 'plan');
%! records = executeLocal (jobs, Case, @(s) []);
%! assert ({records.status}, repmat ({'ok'}, 1, 4));
%! assert (records(3).results, [3 + 4, 3 * 4], 1e-12);
%! assert (records(4).results, 3 - 4, 1e-12);
%!test
%! % each way to fail is a record; nothing is thrown
%! Case = quickCase ();
%! run = fullfile (Case.models(2).folder, 'runscript');
%! writeAtomic (run, "echo 'ERROR: too dense'; exit 3\n");
%! r = executeLocal (newJobs (Case, [1, 2], [], 1, 'plan')(2), Case, @(s) []);
%! assert ({r.status, r.cause}, {'failed', 'exit'});
%! assert (! isempty (strfind (r.message, 'too dense')));
%! writeAtomic (run, "sleep 100 & sleep 100\n");
%! Case.models(2).timeout = 1;
%! r = executeLocal (newJobs (Case, [1, 2], [], 2, 'plan')(2), Case, @(s) []);
%! assert (r.status, 'timeout');
%! writeAtomic (run, "echo nan > out\n");
%! Case.models(2).timeout = NaN;
%! r = executeLocal (newJobs (Case, [1, 2], [], 3, 'plan')(2), Case, @(s) []);
%! assert (r.status, 'invalid');
%! writeAtomic (run, "kill -9 $$\n");
%! r = executeLocal (newJobs (Case, [1, 2], [], 4, 'plan')(2), Case, @(s) []);
%! assert (r.cause, 'killed');
%!testif ; ! isempty (file_in_path (getenv ('PATH'), 'mpirun'))
%! % ranks of concurrent MPI runs may use all cores
%! Case = quickCase ();
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
