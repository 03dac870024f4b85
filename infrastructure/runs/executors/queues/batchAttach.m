% BATCHATTACH  Starts the book of a plan: which runs are in the queue already.
%
% CALL: QUEUESTATE = batchAttach (JOBS, CASE, QUEUE)
%
%   JOBS, CASE, QUEUE  see batchExecute
%   QUEUESTATE  scalar struct
%     status   1 x n char: 'q' to be submitted, 'o' submitted and open,
%              'e' ended and to be evaluated, 's' settled (has a record)
%     isOld    1 x n logical, submitted by an earlier start of Octave
%     folder   1 x n cell of run folders, '' if there is none yet
%     batch    1 x n index into batches, 0 = none
%     task     1 x n number of the task in the array
%     since    1 x n time (s, clock of toc) at which the queue first said that
%              the run has ended, NaN = it has not
%     records  1 x n cell of run records
%     state    1 x n char, what the queue last said of the job, see pollQueue
%     word     1 x n cell, the same in its own words
%     batches  1 x b struct array: name, path, n (tasks), left (runs without a
%              record at the start), cpu, minutes, isSent
%     silent   logical, the controller did not answer the last time
%     waitsFor reason for waiting that the user knows already (text)
%     message  text for the user, '' = nothing new
%
% A run whose record is written, whose folder is gone, which was given up
% (abandonRun) or which is that of another case is not attached: of that one's
% jobs the queue may say nothing here.

function queueState = batchAttach (jobs, Case, queue)
  n = numel (jobs);
  none = repmat ({''}, 1, n);
  queueState = struct ('status', repmat ('q', 1, n), 'isOld', false (1, n), ...
                       'folder', {none}, 'state', repmat ('-', 1, n), ...
                       'word', {none}, ...
                       'batch', zeros (1, n), 'task', zeros (1, n), ...
                       'since', NaN (1, n), 'records', {cell(1, n)}, ...
                       'silent', false, 'waitsFor', '', 'message', '');
  queueState.batches = struct ('name', {}, 'path', {}, 'n', {}, 'left', {}, ...
                               'cpu', {}, 'minutes', {}, 'isSent', {});
  for sent = readSubmissions (runPlace (Case, ['.', queue.name]))
    isOpen = cellfun (@isAttachable, sent.folders);
    if ~any (isOpen)
      batchDiscard (sent.path);
    end
    isOpen(isOpen) = cellfun (@(f) isOwn (f, Case), sent.folders(isOpen));
    sent.keys(~isOpen) = {''};
    [isOurs, task] = ismember ({jobs.key}, sent.keys);
    isOurs = isOurs & queueState.status == 'q';
    if ~any (isOurs)
      continue
    end
    queueState.batches(end + 1) = struct ('name', sent.name, 'path', sent.path, ...
                                          'n', numel (isOpen), ...
                                          'left', sum (isOpen), 'cpu', NaN, ...
                                          'minutes', NaN, 'isSent', true);
    queueState.batch(isOurs) = numel (queueState.batches);
    queueState.task(isOurs) = task(isOurs);
    queueState.folder(isOurs) = sent.folders(task(isOurs));
    queueState.status(isOurs) = 'o';
    queueState.isOld(isOurs) = true;
  end
  if any (queueState.isOld)
    queueState.message = sprintf (['%d run(s) submitted to %s earlier are ' ...
                                   'taken up again.'], sum (queueState.isOld), ...
                                  queue.title);
  end
end

function yes = isAttachable (folder)
  has = @(varargin) isfile (fullfile (folder, varargin{:}));
  yes = has ('job.json') && ~has ('record.json') && ...
        ~has ('batch.claim', 'void');
end

function yes = isOwn (folder, Case)
  yes = isOwnRun (readRecord (fullfile (folder, 'job.json')), Case);
end

%!test
%! store = tempname ();
%! batch = fullfile (store, 'optim', '.q', 'decalioc-1');
%! mkdir (batch);
%! lines = arrayfun (@(k) sprintf ("k%d\t%s/%d\n", k, store, k), 1:3, ...
%!                   'UniformOutput', false);
%! writeAtomic (fullfile (batch, 'tasks'), [lines{:}]);
%! for file = {'1/job.json', '2/job.json', '2/record.json'}
%!   [~, ~] = mkdir (fileparts (fullfile (store, file{1})));
%!   writeAtomic (fullfile (store, file{1}), '');
%! end
%! jobs = struct ('key', {'k0', 'k1', 'k2', 'k3'});
%! queue = struct ('name', 'q', 'title', 'Queue');
%! Case = struct ('store', store, 'folder', '/a');
%! assert (batchAttach (jobs, Case, queue).status, 'qqqq');
%! assert (isfolder (batch));
%! Case.folder = store;
%! f = batchAttach (jobs, Case, queue);
%! assert (f.status, 'qoqq');
%! assert (f.task, [0, 1, 0, 0]);
%! assert (f.folder{2}, [store, '/1']);
%! assert ([f.batches.n, f.batches.left], [3, 1]);
%! assert (! isempty (f.message));
%! rmdir (store, 's');
%! f = batchAttach (jobs, Case, queue);
%! assert (f.status, 'qqqq');
%! assert (isempty (f.batches) && isempty (f.message));

% SPDX-License-Identifier: GPL-3.0-only
