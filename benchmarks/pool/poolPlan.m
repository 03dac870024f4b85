% POOLPLAN  Carries out runs in workers of parcellfun: a trial, see pool.m.
%
% CALL: [RECORDS, LOG] = poolPlan (JOBS, CASE, REPORT)
%
%   JOBS, CASE, REPORT, RECORDS  see executeLocal; all runs take one CPU
%   LOG  scalar struct: calls (of parcellfun), workers (that it gave)
%
% Each call of the worker function takes the next run (claimed on disk), waits
% for it under its guard, evaluates it and writes the record. The caller gets
% control back at each result (CumFunc). When a worker dies the caller reads the
% records, waits for runs whose guards go on, and starts the missing ones again.
%
% See also: poolWorker, executeLocal

function [records, log] = poolPlan (jobs, Case, report)
  place = tempname ();
  mkdir (place);
  log = struct ('calls', 0, 'workers', 0);
  folders = repmat ({''}, 1, numel (jobs));
  isDone = false (1, numel (jobs));
  state = struct ('total', numel (jobs), 'done', 0, 'failed', 0, ...
                  'running', 0, 'seconds', 0);
  while ~all (isDone)
    todo = find (~isDone);
    log.calls = log.calls + 1;
    log.workers = min ([Case.options.maxCPU, nproc(), numel(todo)]);
    book = struct ('place', place, 'todo', todo, 'owner', getpid ());
    save ('-binary', fullfile (place, 'book'), 'jobs', 'Case', 'book');
    try
      parcellfun (log.workers, @(k) poolWorker (k, place), ...
                  num2cell ([0, todo]), 'CumFunc', ...
                  @(a, b) tell (a, b, report, state), 'VerboseLevel', 0);
    catch
      % a worker is gone, and parcellfun has ended the others as well
    end
    [folders, isDone] = whatIsDone (place, folders);
  end
  records = cellfun (@(f) readRecord (fullfile (f, 'record.json')), folders);
  confirm_recursive_rmdir (false, 'local');
  rmdir (place, 's');
end

function n = tell (a, b, report, state)
  n = a + b;
  state.done = n;
  report (state);
end

function [folders, isDone] = whatIsDone (place, folders)
  for i = 1:numel (folders)
    claim = fullfile (place, sprintf ('%d', i));
    if isempty (folders{i}) && isfile (fullfile (claim, 'folder'))
      folders{i} = fileread (fullfile (claim, 'folder'));
    end
  end
  isDone = ~cellfun (@isempty, folders) & ...
           cellfun (@(f) isfile (fullfile (f, 'record.json')), folders);
end
