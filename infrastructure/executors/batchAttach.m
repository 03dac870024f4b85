% BATCHATTACH  Starts the book of a plan: which runs are in the queue already.
%
% CALL: FLIGHT = batchAttach (JOBS, STORE, QUEUE)
%
%   JOBS    1 x n struct array, see newJobs
%   STORE   folder of the run store (text)
%   QUEUE   see newQueue
%   FLIGHT  scalar struct
%     status   1 x n char: 'q' to be submitted, 'o' submitted and open,
%              'e' ended and to be evaluated, 's' settled (has a record)
%     isOld    1 x n logical, submitted by an earlier start of Octave
%     folder   1 x n cell of run folders, '' if there is none yet
%     batch    1 x n index into batches, 0 = none
%     task     1 x n number of the task in the array
%     since    1 x n time (s, clock of toc) at which the queue first said that
%              the run has ended, NaN = it has not
%     records  1 x n cell of run records
%     state    1 x n char, what the queue last said of the job, see batchJudge
%     word     1 x n cell, the same in its own words
%     batches  1 x b struct array: name, path, n (tasks), left (runs without a
%              record at the start), cpu, minutes, isSent
%     silent   logical, the controller did not answer the last time
%     waitsFor reason for waiting that the user knows already (text)
%     message  text for the user, '' = nothing new
%
% A run whose record is written, whose folder is gone, or which was given up
% (batchVoid) is not attached.

function flight = batchAttach (jobs, store, queue)
  n = numel (jobs);
  none = repmat ({''}, 1, n);
  flight = struct ('status', repmat ('q', 1, n), 'isOld', false (1, n), ...
                   'folder', {none}, 'state', repmat ('-', 1, n), ...
                   'word', {none}, ...
                   'batch', zeros (1, n), 'task', zeros (1, n), ...
                   'since', NaN (1, n), 'records', {cell(1, n)}, ...
                   'silent', false, 'waitsFor', '', 'message', '');
  flight.batches = struct ('name', {}, 'path', {}, 'n', {}, 'left', {}, ...
                           'cpu', {}, 'minutes', {}, 'isSent', {});
  ledger = batchLedger (store, queue.name);
  for b = 1:numel (ledger)
    isOpen = cellfun (@isAttachable, ledger(b).folders);
    [isOurs, task] = ismember ({jobs.key}, ledger(b).keys(isOpen));
    isOurs = isOurs & flight.status == 'q';
    if ~any (isOpen)
      batchDiscard (ledger(b).path);
    end
    if ~any (isOurs)
      continue
    end
    places = find (isOpen);
    task(isOurs) = places(task(isOurs));
    flight.batches(end + 1) = struct ('name', ledger(b).name, ...
                                      'path', ledger(b).path, ...
                                      'n', numel (isOpen), ...
                                      'left', sum (isOpen), 'cpu', NaN, ...
                                      'minutes', NaN, 'isSent', true);
    flight.batch(isOurs) = numel (flight.batches);
    flight.task(isOurs) = task(isOurs);
    flight.folder(isOurs) = ledger(b).folders(task(isOurs));
    flight.status(isOurs) = 'o';
    flight.isOld(isOurs) = true;
  end
  if any (flight.isOld)
    flight.message = sprintf (['%d run(s) submitted to %s earlier are ' ...
                               'taken up again.'], sum (flight.isOld), ...
                              queue.title);
  end
end

function yes = isAttachable (folder)
  yes = exist (fullfile (folder, 'job.json'), 'file') == 2 && ...
        ~exist (fullfile (folder, 'record.json'), 'file') && ...
        ~exist (fullfile (folder, 'batch.claim', 'void'), 'file');
end

%!function store = ledgerWith (lines, folders, files)
%!  store = tempname ();
%!  mkdir (fullfile (store, 'optim', '.q', 'decalioc-1'));
%!  for k = 1:numel (folders)
%!    mkdir (store, folders{k});
%!    fclose (fopen (fullfile (store, folders{k}, 'job.json'), 'w'));
%!    if ! isempty (files{k})
%!      fclose (fopen (fullfile (store, folders{k}, files{k}), 'w'));
%!    end
%!  end
%!  place = fullfile (store, 'optim', '.q', 'decalioc-1');
%!  fid = fopen (fullfile (place, 'tasks'), 'w');
%!  fprintf (fid, strrep (lines, 'STORE', store));
%!  fclose (fid);
%!endfunction
%!test
%! store = ledgerWith ("k1\tSTORE/1\nk2\tSTORE/2\nk3\tSTORE/3\n", ...
%!                     {'1', '2'}, {'', 'record.json'});
%! jobs = struct ('key', {'k0', 'k1', 'k2', 'k3'});
%! queue = struct ('name', 'q', 'title', 'Queue');
%! f = batchAttach (jobs, store, queue);
%! assert (f.status, 'qoqq');
%! assert (f.task, [0, 1, 0, 0]);
%! assert (f.folder{2}, [store, '/1']);
%! assert ([f.batches.n, f.batches.left], [3, 1]);
%! assert (! isempty (f.message));
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (store, 's');
%! f = batchAttach (jobs, store, queue);
%! assert (f.status, 'qqqq');
%! assert (isempty (f.batches) && isempty (f.message));
