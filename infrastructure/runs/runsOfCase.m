% RUNSOFCASE  All runs of a case that the store holds, whatever their state.
%
% CALL: RUNS = runsOfCase (CASE)
%
%   CASE  see newCase
%   RUNS  1 x n struct array: model (number), folder, job (see newJobs), state,
%         seconds (NaN: not known), message, results, isCurrent (its key is
%         what the case gives today), arrays (of an open one: n x 2 cell, the
%         job arrays in which it was sent: executor, name). States: 'ok', 'failed', 'timeout',
%         'invalid' (as in its record), 'ended' (not evaluated yet, or not as the
%         case asks today: readingOf), 'running', 'waiting' (prepared, or in a
%         queue), 'lost' (ended from outside, by decalioc cancel say, or its
%         guard is gone, or copied in part, see readRun: to be run again)
%
% Reads files alone; works beside a running Octave and on a machine that is not
% the one of the runs, of which it then takes their word.

function runs = runsOfCase (Case)
  runs = struct ('model', {}, 'folder', {}, 'job', {}, 'state', {}, ...
                 'seconds', {}, 'message', {}, 'results', {}, ...
                 'isCurrent', {}, 'arrays', {});
  if ~all (cellfun (@isfolder, {Case.models.folder}))
    return
  end
  Case.hashes = hashModels (Case);
  sent = sentRuns (Case);
  isHere = any (strcmp (lockHolder (Case.folder).host, {'', gethostname()}));
  for k = 1:numel (Case.models)
    place = runPlace (Case, Case.models(k).name);
    for name = runFoldersOf (Case, Case.models(k).name)'
      run = oneRun (fullfile (place, name{1}), sent, isHere, Case.hashes(k));
      % what another case has under way on the same store is not ours; what has
      % ended is told apart by the index (runFoldersOf)
      isOpen = ~isempty (run) && ...
               any (strcmp (run.state, {'running', 'waiting', 'lost', 'ended'}));
      if ~isempty (run) && (~isOpen || isOwnRun (run.job, Case))
        run.model = k;
        run.isCurrent = ~isempty (countsToday (run.job, run.folder, ...
                                               Case, Case.hashes(k)));
        runs(end + 1) = orderfields (run, runs);
      end
    end
  end
end

% n x 3 cell: folder, executor, name of the job array.
function sent = sentRuns (Case)
  sent = cell (0, 3);
  for name = executorNames ('described')
    for batch = readSubmissions (runPlace (Case, ['.', name{1}]))
      in = repmat ({name{1}, batch.name}, numel (batch.folders), 1);
      sent = [sent; batch.folders(:), in];
    end
  end
end

% [] where the folder is half made.
function run = oneRun (folder, sent, isHere, h)
  run = struct ('model', 0, 'folder', folder, 'job', [], 'state', '', ...
                'seconds', NaN, 'message', '', 'results', [], ...
                'isCurrent', false, 'arrays', {cell(0, 2)});
  run.job = readingOf (readSane (fullfile (folder, 'record.json')), h);
  if isfield (run.job, 'status')
    run.state = run.job.status;
    for field = {'seconds', 'message', 'results'}
      run.(field{1}) = run.job.(field{1});
    end
    return
  end
  run.job = readSane (fullfile (folder, 'job.json'));
  mark = readEndMark (folder);
  if isempty (run.job)
    run = [];
  elseif strcmp (givenField (mark, 'reason', ''), 'killed') || ...
         (~isempty (mark) && ~isfile (fullfile (folder, 'runscript')))
    run.state = 'lost';
  elseif ~isempty (mark)
    run.state = 'ended';
    run.seconds = mark.seconds;
  else
    run.arrays = sent(strcmp (folder, sent(:, 1)), 2:3);
    run.state = stateOf (folder, ~isempty (run.arrays), isHere);
  end
end

function state = stateOf (folder, isSent, isHere)
  [pids, ~, ~, isGone] = runPids (folder);
  hasBegun = ~isempty (pids);
  if isSent
    hasBegun = exist (fullfile (folder, 'batch.claim'), 'file') > 0;
  end
  if ~hasBegun
    state = 'waiting';
  elseif ~isSent && isHere && isGone
    state = 'lost';
  else
    state = 'running';
  end
end

%!test
%! % one run in each state that a single machine knows
%! Case = readyCase ();
%! jobs = newJobs (Case, [1, 2; 3, 4; 5, 6; 7, 8], [], 1, 'plan')(1:2:end);
%! folders = arrayfun (@(j) prepareRun (j, Case), jobs, 'UniformOutput', false);
%! startRun (folders{1}, Case.root);
%! waitUntil (@() ~isempty (readEndMark (folders{1})));
%! [~, mark] = processStart (getpid ());
%! writeAtomic (fullfile (folders{2}, 'pid'), ...
%!              sprintf ("%d 1 %s\n", getpid (), mark));
%! % of a boot before this one: another process has the number now
%! writeAtomic (fullfile (folders{3}, 'pid'), ...
%!              sprintf ("%d 1 1%s\n", getpid (), mark));
%! assert ({runsOfCase(Case).state}, {'ended', 'running', 'lost', 'waiting'});
%! collectRuns (jobs(1), folders(1), Case);
%! failedRecord (jobs(3), folders{3}, 'timeout', 'too slow', 'time');
%! runs = runsOfCase (Case);
%! assert ({runs.state}, {'ok', 'running', 'timeout', 'waiting'});
%! assert (runs(1).results, [3, 2]);
%! assert (runs(3).message, 'too slow');
%! assert ([runs.isCurrent], true (1, 4));
%! % an edited model makes other runs of them
%! writeAtomic (fullfile (Case.models(1).folder, 'extra'), 'x');
%! assert ([runsOfCase(Case).isCurrent], false (1, 4));
%!test
%! % jobs in the queue of a cluster, one of them begun
%! Case = readyCase ();
%! jobs = newJobs (Case, [1, 2; 3, 4], [], 1, 'plan')(1:2:end);
%! folders = arrayfun (@(j) prepareRun (j, Case), jobs, 'UniformOutput', false);
%! batch = fullfile (Case.store, 'optim', '.slurm', 'decalioc-1');
%! mkdir (batch);
%! writeAtomic (fullfile (batch, 'tasks'), ...
%!              sprintf ("k1\t%s\nk2\t%s\n", folders{:}));
%! mkdir (fullfile (folders{2}, 'batch.claim'));
%! assert ({runsOfCase(Case).state}, {'waiting', 'running'});

% SPDX-License-Identifier: GPL-3.0-only
