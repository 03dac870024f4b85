% BATCHSUBMIT  Prepares runs and writes down that they go to a queue together.
%
% CALL: QUEUESTATE = batchSubmit (QUEUESTATE, PICKS, JOBS, CASE, QUEUE, OPT)
%
%   QUEUESTATE            see batchAttach
%   PICKS             1 x k indices into JOBS, models with the same CPUs
%   JOBS, CASE        see batchExecute
%   QUEUE, OPT        see newQueue
%
% Makes the run folders and a batch folder <store>/optim/.<queue>/<name> whose
% file tasks tells which task of the array is which run. The name is unique and
% becomes the job name: the array is found by it even when its number was never
% heard of. Nothing is sent yet.
%
% Errors: DEcalioc:batchSubmit:badValue, those of prepareRun

function queueState = batchSubmit (queueState, picks, jobs, Case, queue, opt)
  models = Case.models;
  [~, k] = ismember ({jobs(picks).model}, {models.name});
  limits = [models(k).timeout];
  minutes = batchMinutes (opt.time, limits);
  % the guard ends a run before the queue does: exactly, with an end mark
  limits = max (limits, arrayfun (@defaultLimit, models(k)));
  seconds = max (1, floor (min (limits, 60 * minutes - 10)));
  lines = cell (1, numel (picks));
  for i = 1:numel (picks)
    job = jobs(picks(i));
    folder = prepareRun (job, Case);
    if any (ismember (folder, "\t\n\r"))
      error ('DEcalioc:batchSubmit:badValue', ...
             ['batchSubmit: the path of the run store must be free of tabs ' ...
              'and line breaks, got %s. Rename the folder.'], folder);
    end
    writeAtomic (fullfile (folder, 'limit'), ...
                 sprintf ("%d\n", seconds(i)), false);
    queueState.folder{picks(i)} = folder;
    lines{i} = sprintf ("%s\t%s\n", job.key, folder);
  end
  batch = struct ('name', newName (lines), 'path', '', ...
                  'n', numel (picks), 'left', numel (picks), 'cpu', ...
                  models(k(1)).cpu, 'minutes', minutes, 'isSent', false);
  batch.path = runPlace (Case, ['.', queue.name], batch.name);
  % the queue writes into it as this user, whatever link it finds there
  [~, ~] = mkdir (fileparts (batch.path));
  privateFolder (batch.path);
  writeAtomic (fullfile (batch.path, 'tasks'), [lines{:}]);
  queueState.batches(end + 1) = batch;
  queueState.batch(picks) = numel (queueState.batches);
  queueState.task(picks) = 1:numel (picks);
  queueState.status(picks) = 'o';
  queueState.isOld(picks) = false;
  queueState.since(picks) = NaN;
end

function name = newName (lines)
  text = sprintf ('%s %.17g %.17g %d', lines{1}, time (), cputime (), ...
                  getpid ());
  name = ['decalioc-', hash('md5', text)(1:12)];
end

%!test
%! [Case, jobs] = slurmTestCase (tempname (), 1:3, 0);
%! Case.models.timeout = 7;
%! queue = struct ('name', 'q', 'title', 'Queue');
%! opt = slurmExecutor ().options (struct ('slurm', struct ( ...
%!                            'before', {{'module load a', 'b=1'}})));
%! queueState = batchAttach (jobs, Case, queue);
%! queueState = batchSubmit (queueState, [1, 3], jobs, Case, queue, opt);
%! assert (queueState.status, 'oqo');
%! assert (queueState.task([1, 3]), [1, 2]);
%! assert (fileread (fullfile (queueState.folder{3}, 'limit')), "7\n");
%! assert (queueState.batches.isSent, false);
%! assert (queueState.batches.minutes, 3);
%! % without a limit of the user's, the one that earlier runs teach
%! Case.models.timeout = NaN;
%! Case.models.seconds = [10, 10, 10];
%! later = batchSubmit (queueState, 2, jobs, Case, queue, opt);
%! assert (fileread (fullfile (later.folder{2}, 'limit')), "200\n");
%! assert (later.batches(2).minutes, 24 * 60);
%! % a new start knows of all
%! again = batchAttach (jobs, Case, queue);
%! assert (again.status, 'ooo');
%! assert (again.folder, later.folder);
%! assert (again.isOld, [true, true, true]);
%!error id=DEcalioc:batchSubmit:badValue
%! [Case, jobs] = slurmTestCase (tempname (), 1, 0);
%! Case.store = [Case.store, "\tx"];
%! queue = slurmExecutor ();
%! batchSubmit (batchAttach (jobs, Case, queue), 1, jobs, Case, ...
%!              queue, queue.options (struct ()));

% SPDX-License-Identifier: GPL-3.0-only
