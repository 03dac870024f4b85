% BATCHEXECUTE  Carries out runs on a cluster, as job arrays of its queue.
%
% CALL: RECORDS = batchExecute (QUEUE, JOBS, CASE, REPORT)
%
%   QUEUE    see newQueue
%   JOBS     1 x n struct array, see newJobs
%   CASE     see newCase. The cluster decides how much runs at a time, not
%            CASE.options.maxCPU
%   REPORT   function handle, called with the state when it has changed: total,
%            done, failed, running, seconds, message ('' or a text for
%            the user)
%   RECORDS  1 x n struct array, see newRecord
%
% Each run is done by guard.sh on a node of the cluster and leaves an end mark
% in its folder; the queue is asked only for what left none. When this is
% left early (Ctrl-C, an error, kill -9), what is in the queue stays there. The
% next call with the same jobs takes it up again: nothing is submitted twice,
% nothing that has ended is repeated. decalioc cancel empties the queue.
%
% Errors: DEcalioc:batchExecute:missingFile    no such queue on this machine
%         DEcalioc:batchExecute:submitRefused  partition, account, limits ...
%         those of prepareRun

function records = batchExecute (queue, jobs, Case, report)
  opt = queue.options (Case.options);
  [opt.arraySize, fault] = queue.start ();
  if ~isempty (fault)
    error ('DEcalioc:batchExecute:missingFile', ...
           ['batchExecute: this machine must be one of a cluster with %s, ' ...
            'got: %s. Start on a machine where jobs can be submitted, or ' ...
            'set Input.executor = ''local''.'], queue.title, fault);
  end
  watch = tic ();
  queueState = batchAttach (jobs, Case, queue);
  reported = struct ();
  while true
    queueState = pollQueue (queueState, jobs, queue, opt.grace, toc (watch));
    queueState = collect (queueState, jobs, Case);
    queueState = launch (queueState, jobs, Case, queue, opt);
    state = stateOf (queueState);
    state.message = queueState.message;
    if ~isequal (state, reported)
      reported = state;
      reported.message = '';
      state.seconds = toc (watch);
      report (state);
      queueState.message = '';
    end
    if all (queueState.status == 's')
      break
    end
    pause (opt.poll);
  end
  records = [queueState.records{:}];
end

function queueState = collect (queueState, jobs, Case)
  ended = queueState.status == 'e';
  if any (ended)
    queueState.records(ended) = num2cell (collectRuns (jobs(ended), ...
                                                       queueState.folder(ended), Case));
    queueState.status(ended) = 's';
    setLimits (queueState, jobs, Case);
  end
  queueState = retire (queueState);
end

% Removes the folders of batches of which no run is open, here or elsewhere.
function queueState = retire (queueState)
  held = queueState.batch(queueState.status == 'o' | queueState.status == 'e');
  for b = setdiff (queueState.batch(queueState.batch > 0), held)
    isGone = queueState.batch == b;
    if queueState.batches(b).left == sum (isGone)
      batchDiscard (queueState.batches(b).path);
    end
    queueState.batch(isGone) = 0;
  end
end

function setLimits (queueState, jobs, Case)
  done = [queueState.records{:}];
  for model = Case.models
    limit = defaultLimit (model, done);
    isOpen = queueState.status == 'o' & strcmp ({jobs.model}, model.name);
    for i = find (isOpen & ~isnan (limit))
      most = 60 * queueState.batches(queueState.batch(i)).minutes - 10;
      writeAtomic (fullfile (queueState.folder{i}, 'limit'), ...
                   sprintf ("%d\n", floor (min (limit, most))));
    end
  end
end

% Fills the queue up to maxInFlight, a quarter of it at least at a time.
function queueState = launch (queueState, jobs, Case, queue, opt)
  queueState = send (queueState, queue, opt, Case.root);
  waiting = find (queueState.status == 'q');
  free = opt.maxInFlight - sum (queueState.status == 'o');
  isWorth = free >= min (numel (waiting), ceil (opt.maxInFlight / 4));
  if isempty (waiting) || ~isWorth || ~all ([queueState.batches.isSent])
    return
  end
  picks = waiting(1:min (numel (waiting), floor (free)));
  for part = batchParts (picks, jobs, Case, opt)
    queueState = batchSubmit (queueState, part{1}, jobs, Case, queue, opt);
    queueState = send (queueState, queue, opt, Case.root);
  end
end

function queueState = send (queueState, queue, opt, root)
  for b = find (~[queueState.batches.isSent])
    task = batchCall (queueState.batches(b).path, queue, opt, root);
    [verdict, text] = queue.send (queueState.batches(b), opt, task);
    isAlone = ~any (queueState.status == 'o' & queueState.batch ~= b);
    queueState.batches(b).isSent = strcmp (verdict, 'sent');
    if strcmp (verdict, 'refused') && isAlone
      cellfun (@abandonRun, queueState.folder(queueState.status == 'o' & ...
                                              queueState.batch == b));
      batchDiscard (queueState.batches(b).path);
      error ('DEcalioc:batchExecute:submitRefused', ...
             ['batchExecute: %s must accept %d job(s), got: %s. Correct ' ...
              'Input.%s (where there is a limit on the number of jobs: ' ...
              'maxInFlight) and start again.'], queue.title, ...
             queueState.batches(b).n, text, queue.name);
    elseif ~strcmp (verdict, 'sent') && ~strcmp (text, queueState.waitsFor)
      queueState.waitsFor = text;
      queueState.message = [queue.title, ' takes no jobs now, trying on: ', text];
    end
  end
end

function state = stateOf (queueState)
  isOpen = queueState.status == 'o';
  status = cellfun (@(r) r.status, queueState.records(queueState.status == 's'), ...
                    'UniformOutput', false);
  state = struct ('total', numel (isOpen), 'done', numel (status), ...
                  'failed', sum (~strcmp (status, 'ok')), ...
                  'running', sum (isOpen & queueState.state == 'r'));
end

%!function [ok, text, isPassing] = submit (batch, opt, task)
%!  % a queue that starts all tasks of an array on this machine at once
%!  words = strjoin (cellfun (@shellQuote, task, 'UniformOutput', false), ' ');
%!  for k = 1:batch.n
%!    system (sprintf ('T=%d J=1 setsid bash %s > /dev/null 2>&1 &', k, words));
%!  end
%!  [ok, text, isPassing] = deal (true, '', false);
%!endfunction
%!function [ok, text, tasks] = look (names, sizes)
%!  [ok, text] = deal (true, '');
%!  tasks = struct ('state', arrayfun (@(n) {repmat('r', 1, n)}, sizes), ...
%!                  'word', arrayfun (@(n) {repmat({''}, 1, n)}, sizes));
%!endfunction
%!shared queue, traits, Case, jobs
%! traits = struct ('name', 'q', 'title', 'Queue', 'words', {{}}, 'task', ...
%!                  {{'T', 'J'}}, 'start', @() deal (2, ''), 'submit', ...
%!                  @submit, 'look', @look);
%! queue = newQueue (traits);
%! [Case, jobs] = slurmTestCase (tempname (), [1, 9, 3], 0);
%! Case.options.q = struct ('poll', 0.1);
%!test
%! % arrays of two tasks at most; nothing is left of them
%! text = evalc (['r = batchExecute (queue, jobs, Case, ', ...
%!                '@(s) printf (''%d/%d '', s.done, s.total));']);
%! assert ({r.key}, {jobs.key});
%! assert ({r.status}, {'ok', 'failed', 'ok'});
%! assert ([r.results], [2, 1, 5, 6], 1e-12);
%! assert (strncmp (text, '0/3 ', 4) && strcmp (text(end - 3:end), '3/3 '));
%! place = fullfile (Case.store, 'optim', '.q');
%! assert (readdir (place), {'.'; '..'});
%!error <Queue, got: no master>
%! queue.start = @() deal (0, 'no master');
%! batchExecute (queue, jobs, Case, @(s) []);
%!error id=DEcalioc:batchExecute:submitRefused
%! traits.submit = @(batch, opt, task) deal (false, 'no', false);
%! traits.look = @(names, sizes) deal (true, '', struct ('state', '-'));
%! queue = newQueue (setfield (traits, 'start', @() deal (2, '')));
%! Case.store = tempname ();
%! batchExecute (queue, jobs, Case, @(s) []);

% SPDX-License-Identifier: GPL-3.0-only
