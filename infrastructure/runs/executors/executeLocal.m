% EXECUTELOCAL  Carries out runs on this machine, in workers of parcellfun.
%
% CALL: RECORDS = executeLocal (JOBS, CASE, REPORT)
%
%   JOBS     1 x n struct array, see newJobs
%   CASE     see newCase; CASE.options.maxCPU is shared by all models
%   REPORT   function handle, called with the state after each change
%   RECORDS  1 x n struct array, see newRecord
%
% One call of parcellfun carries the plan. A worker that has nothing to do comes
% back (CumFunc) and is kept here until a run can be started or evaluated: that
% is its next turn (carryRun). A run starts as soon as its CPUs are free, those
% that need many CPUs first, so runs of uneven length keep all CPUs busy. No
% worker waits for a run, so more can be under way than there are workers.
%
% Each simulation is a process of its own under guard.sh. When this function is
% left early (Ctrl-C, an error) the simulations under way are ended; when Octave
% is killed, the guards see it and end them. A killed worker loses the call; the
% next one goes on with what the folders say. Without Input.timeout the time
% limit of a run is 20 times the median of the model's runs in this calibration,
% and at least 60 s.
%
% Errors: DEcalioc:executeLocal:runFailed, DEcalioc:giveOrder:cannotWrite, those
% of prepareRun and startRun

function records = executeLocal (jobs, Case, report)
  % a map, for CumFunc and what tidies up must see the same plan, and a nested
  % function would keep alive the very frame whose end the tidying waits for
  book = containers.Map ({'plan'}, {newPlan(jobs, Case)}, ...
                         'UniformValues', false);
  plan = book('plan');
  place = plan.place;
  owner = getpid ();
  slim = struct ('root', Case.root, 'store', Case.store, 'models', ...
                 Case.models, 'modelVars', Case.modelVars, 'names', ...
                 {Case.names}, 'effectVars', {Case.effectVars}, ...
                 'folder', Case.folder, ...
                 'hashes', hashModels (Case));
  turn = @(k) carryRun (place, slim, owner);
  hand = @(a, b) handOut (book, [a, b], Case, report);
  tidy = onCleanup (@() leave (book));
  while ~all (plan.status == 'd')
    try
      % a run has two steps; what is open when the turns end, the next call does
      plan.turns = 64;
      book('plan') = plan;
      turns = num2cell (1:plan.turns);
      [~] = parcellfun (plan.workers, turn, turns, 'CumFunc', hand, ...
                        'UniformOutput', false, 'VerboseLevel', 0);
    catch err
      book('plan') = afterLoss (book('plan'), err, Case, report);
    end
    plan = book('plan');
  end
  records = plan.records;
end

% STATUS of a run: q waits, b is being begun, r under way, e ended, j is being
% evaluated, d done. More than 8 workers would have nothing to do.
function plan = newPlan (jobs, Case)
  n = numel (jobs);
  [~, model] = ismember ({jobs.model}, {Case.models.name});
  last = cellfun (@(name) getLastFoldersNumber (runPlace (Case, name)), ...
                  {Case.models.name});
  plan = struct ('jobs', jobs, 'cpus', [Case.models(model).cpu], ...
                 'model', model, 'foreseen', zeros (1, n), ...
                 'status', repmat ('q', 1, n), 'folders', {cell(1, n)}, ...
                 'born', zeros (1, n), 'usual', NaN (1, n), 'last', last, ...
                 'records', repmat (newRecord (jobs(1), ''), 1, n), ...
                 'place', privateFolder (), 'workers', min ([8, nproc(), n + 1]), ...
                 'start', tic (), 'guardsSeen', 0, 'losses', 0, 'turns', 0);
end

% A worker is free. It is kept until there is something for it to do, or until
% another one has done its step (or has died), to hear that one's answer.
function none = handOut (book, answers, Case, report)
  none = [];
  plan = book('plan');
  for answer = answers
    plan = bookAnswer (plan, answer, Case, report);
  end
  % with its last turns given out the call must end: nobody would take an order
  plan.turns = plan.turns - 1;
  isKept = plan.turns > plan.workers + 1;
  while isKept && ~all (plan.status == 'd')
    plan = lookAtRuns (plan, Case, report);
    [plan, k] = nextStep (plan, Case);
    if isempty (k)
      isStep = plan.status == 'b' | plan.status == 'j';
      isOn = isStep | plan.status == 'r';
      usual = plan.usual;
      usual(isStep) = NaN;
      pause (lookAfter (toc (plan.start) - plan.born(isOn), usual(isOn)));
      isKept = sum (isStep) <= stepsAtWork (plan.place);
    else
      book('plan') = plan;                 % before a worker can begin it
      giveOrder (plan.place, ...
                 struct ('k', k, 'job', plan.jobs(k), ...
                         'folder', plan.folders{k}, ...
                         'hasEnded', plan.status(k) == 'j'));
      isKept = false;
    end
  end
  book('plan') = plan;
end

% An order is whole, or not there. Not by writeAtomic: it need not outlive a
% power cut, and a sync would take 20 ms a step.
function giveOrder (place, order)
  draft = fullfile (place, 'draft');
  if ~saveWhole ('-binary', draft, order)
    error ('DEcalioc:giveOrder:cannotWrite', ...
           ['giveOrder: %s must hold what was written to it. The disk of ' ...
            'TMPDIR may be full: free some space and start again; finished ' ...
            'runs are kept.'], draft);
  end
  rename (draft, fullfile (place, sprintf ('%d.order', order.k)));
end

% Orders that nobody has taken yet, and those in the hands of a living worker.
function n = stepsAtWork (place)
  n = 0;
  for name = readdir (place)'
    numbers = sscanf (name{1}, '%d.%d');
    n = n + (numel (numbers) == 1 || ...
             numel (numbers) == 2 && ~isempty (processStart (numbers(2))));
  end
end

function [plan, k] = nextStep (plan, Case)
  isOn = plan.status == 'b' | plan.status == 'r';
  free = Case.options.maxCPU - sum (plan.cpus(isOn));
  fits = find (plan.status == 'q' & plan.cpus <= free);
  fits = fits(plan.cpus(fits) == max (plan.cpus(fits)));
  [~, longest] = max (plan.foreseen(fits));
  k = fits(longest);
  % one worker is kept from getResults, which may take long: to start the next
  % run, and since this Octave acts on no signal where all are at work
  most = max (1, plan.workers - 1);
  if ~isempty (k)
    m = plan.model(k);
    [plan.folders{k}, plan.last(m)] = ...
      takeRunFolder (runPlace (Case, plan.jobs(k).model), plan.last(m) + 1);
    plan.status(k) = 'b';
  elseif sum (plan.status == 'j') < most
    k = find (plan.status == 'e', 1);
    plan.status(k) = 'j';
  end
  plan.born(k) = toc (plan.start);
end

function plan = bookAnswer (plan, answer, Case, report)
  plan.losses = 0;
  if ~isempty (answer.fault)
    error (answer.fault);
  elseif isempty (answer.record)
    plan.status(answer.k) = 'r';
  else
    plan = bookRun (plan, answer.k, answer.record, Case, report);
  end
end

% A look is one stat a run: isfile costs twenty times as much.
function plan = lookAtRuns (plan, Case, report)
  running = find (plan.status == 'r');
  marks = cellfun (@(f) stat ([f, '/end.mark']), plan.folders(running), ...
                   'UniformOutput', false);
  ended = running(~cellfun ('isempty', marks));
  plan.status(ended) = 'e';
  lost = ended(cellfun (@(f) isempty (readEndMark (f)), plan.folders(ended)));
  now = toc (plan.start);
  if now - plan.guardsSeen > 2
    plan.guardsSeen = now;
    running = find (plan.status == 'r');
    lost = [lost, running(cellfun (@isLost, plan.folders(running), ...
                                   num2cell (now - plan.born(running))))];
  end
  for k = lost
    endRun (plan.folders{k});
    record = failedRecord (plan.jobs(k), plan.folders{k}, 'failed', ...
                           'the guard of the run was killed', 'killed');
    plan = bookRun (plan, k, record, Case, report);
  end
end

% A guard that is gone without an end mark was killed. One that has not shown
% up after half a minute never will (a full disk, no shell).
function yes = isLost (folder, age)
  [pids, isAlive] = runPids (folder);
  isGone = isempty (pids) && age > 30 || numel (pids) == 2 && ~isAlive;
  yes = isGone && ~isfile (fullfile (folder, 'end.mark'));
end

% A worker was killed, or getResults has ended it.
function plan = afterLoss (plan, err, Case, report)
  plan.losses = plan.losses + 1;
  if strncmp (err.identifier, 'DEcalioc:', 9)
    rethrow (err);
  elseif plan.losses > 3
    error ('DEcalioc:executeLocal:runFailed', ...
           ['executeLocal: workers of parcellfun must stay alive, four ' ...
            'calls in a row have lost one, got: %s. Is the memory full? ' ...
            'Finished runs are kept.'], err.message);
  end
  endWorkers ();                           % the living ones end here, too
  [~] = cellfun (@(f) unlink (fullfile (plan.place, f)), readdir (plan.place));
  for k = find (plan.status == 'b')
    plan.status(k) = 'r';
    if ~isfile (fullfile (plan.folders{k}, 'job.json'))   % half-made
      plan.status(k) = 'q';
    end
  end
  for k = find (plan.status == 'j')
    plan = bookRun (plan, k, collectRuns (plan.jobs(k), plan.folders(k), ...
                                          Case, true), Case, report);
  end
end

function leave (book)
  plan = book('plan');
  if any (plan.status ~= 'd')              % nothing more is to be started
    endWorkers ();
    for folder = plan.folders(plan.status == 'b' | plan.status == 'r')
      endRun (folder{1});
    end
  end
  confirm_recursive_rmdir (false, 'local');
  rmdir (plan.place, 's');
end

% parcellfun_set_nproc gives an error where it cannot end one (it was killed), which must not
% end a calibration: the next parcellfun makes a pool of its own, or says so.
function endWorkers ()
  try
    parcellfun_set_nproc (0);
  catch
    % see above
  end
end

%!test
%! % records in the order of the jobs; what is reported of them
%! Case = readyCase ();
%! jobs = newJobs (Case, [1, 2; 3, 4], [], 1, 'plan');
%! text = evalc (['r = executeLocal (jobs, Case, @(s) printf (''%d/%d '', ', ...
%!                's.done, s.total));']);
%! assert (text, '1/4 2/4 3/4 4/4 ');
%! assert ({r.key}, {jobs.key});
%! assert ([r.results], [3, 2, -1, 7, 12, -1], 1e-12);
%!test
%! % more steps than one call of parcellfun has turns; workers that are there were killed
%! parcellfun (2, @(x) x, {1, 2}, 'VerboseLevel', 0);
%! system (sprintf ('pkill -KILL -P %d octave', getpid ()));
%! Case = readyCase ();
%! jobs = newJobs (Case, (1:20)' * [1, 1], [], 1, 'plan');
%! r = executeLocal (jobs, Case, @(s) []);
%! assert (all (strcmp ({r.status}, 'ok')));

% SPDX-License-Identifier: GPL-3.0-only
