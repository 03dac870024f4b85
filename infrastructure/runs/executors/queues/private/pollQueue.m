% POLLQUEUE  Looks once at the queue and at the end marks of all open runs.
%
% CALL: QUEUESTATE = pollQueue (QUEUESTATE, JOBS, QUEUE, GRACE, NOW)
%
%   QUEUESTATE  see batchAttach; runs that have ended become 'e' (to be evaluated),
%           's' (record made here: killed, cancelled, node lost, the queue's
%           time limit) or 'q' (to be submitted again)
%   JOBS    see batchExecute
%   QUEUE   see newQueue; its states of a task (char): 'p' it waits, 'r' it runs
%           or may still do something, 't' ended at the queue's time limit, 'e'
%           ended, '-' unknown to the queue; '?' here: it did not answer
%   GRACE   how long files may take to appear (s)
%   NOW     time (s)

function queueState = pollQueue (queueState, jobs, queue, grace, now)
  used = unique (queueState.batch(queueState.status == 'o'));
  used = used([queueState.batches(used).isSent]);
  if isempty (used)
    return
  end
  [ok, text, tasks] = queue.look ({queueState.batches(used).name}, ...
                                  [queueState.batches(used).n]);
  queueState = noteSilence (queueState, ok, text, queue.title);
  for k = 1:numel (used)
    for i = find (queueState.status == 'o' & queueState.batch == used(k))
      [queueState.state(i), queueState.word{i}] = deal ('?', '');
      if ok
        queueState.state(i) = tasks(k).state(queueState.task(i));
        queueState.word{i} = tasks(k).word{queueState.task(i)};
      end
      queueState = lookAtRun (queueState, i, jobs(i), grace, now, queue.title);
    end
  end
  queueState = noteWaiting (queueState, queue.title);
end

function queueState = lookAtRun (queueState, i, job, grace, now, title)
  folder = queueState.folder{i};
  reason = givenField (readEndMark (folder), 'reason', '');
  state = queueState.state(i);
  hasEnded = ~any (state == 'pr?') || strcmp (reason, 'killed');
  if ~hasEnded || state == '?'
    queueState.since(i) = NaN;
  elseif isnan (queueState.since(i))
    queueState.since(i) = now;
  end
  age = max ([0, now - queueState.since(i)]);
  verdict = judgeTask (reason, state, age, grace, queueState.isOld(i));
  switch verdict
    case 'collect'
      queueState.status(i) = 'e';
    case 'again'
      abandonRun (folder);
      queueState.status(i) = 'q';
    case {'failed', 'timeout'}
      abandonRun (folder);
      causes = struct ('failed', 'killed', 'timeout', 'time');
      queueState.records{i} = failedRecord (job, folder, verdict, ...
                                            describe (queueState, i, title), ...
                                            causes.(verdict));
      queueState.status(i) = 's';
  end
end

% What has become of a submitted run. REASON: third word of end.mark, '' = there
% is none. AGE (s): how long STATE has been one of an ended job, or end.mark has
% said 'killed'. A run that ended by itself or by its time limit is collected,
% whatever the queue says; one killed while nobody watched is for a new start.
function verdict = judgeTask (reason, state, age, grace, isOld)
  isLive = any (state == 'pr?');
  isKilled = strcmp (reason, 'killed');
  if ~isempty (reason) && ~isKilled
    verdict = 'collect';
  elseif isLive && ~isKilled || age < grace && (isLive || ~isKilled)
    verdict = 'wait';
  elseif state == 't'
    verdict = 'timeout';
  elseif isOld
    verdict = 'again';
  else
    verdict = 'failed';
  end
end

function text = describe (queueState, i, title)
  word = queueState.word{i};
  if isempty (word)
    word = 'the job is no longer known';
  end
  batch = queueState.batches(queueState.batch(i));
  who = contentOf (fullfile (queueState.folder{i}, 'batch.claim', 'who'));
  if isempty (who)
    who = [batch.name, ', never started'];
  end
  output = contentOf (fullfile (batch.path, ...
                                sprintf ('%d.out', queueState.task(i))));
  text = strtrim (sprintf ('%s: %s, job %s; %s', title, word, who, output));
end

function text = contentOf (file)
  text = '';
  fid = fopen (file, 'r');
  if fid >= 0
    text = asUtf8 (strtrim (fread (fid, [1, 500], 'uint8=>char')));
    fclose (fid);
  end
end

function queueState = noteSilence (queueState, ok, text, title)
  if ~ok && ~queueState.silent
    queueState.message = sprintf (['%s does not answer (%s). Waiting; the runs ' ...
                                   'go on.'], title, strtrim (text));
  elseif ok && queueState.silent
    queueState.message = [title, ' answers again.'];
  end
  queueState.silent = ~ok;
end

% Tells, once for each reason, why nothing runs.
function queueState = noteWaiting (queueState, title)
  isOpen = queueState.status == 'o';
  isWaiting = isOpen & queueState.state == 'p';
  why = '';
  if any (isWaiting) && ~any (isOpen & queueState.state == 'r')
    why = queueState.word(isWaiting){1};
  end
  if ~any (strcmp (why, {'', queueState.waitsFor}))
    queueState.message = sprintf ('%d run(s) wait in the queue of %s: %s', ...
                                  sum (isWaiting), title, why);
    queueState.waitsFor = why;
  end
end

%!function [queueState, jobs] = flightOf (n)
%!  store = emptyFolder ();
%!  jobs = arrayfun (@(k) standInJob (char ('a' + k)), 0:n - 1);
%!  Case = struct ('store', store, 'folder', store);
%!  queueState = batchAttach (jobs, Case, slurmExecutor ());
%!  queueState.status(:) = 'o';
%!  queueState.batch(:) = 1;
%!  queueState.task = 1:n;
%!  queueState.batches(1) = struct ('name', 'b', 'path', store, 'n', n, ...
%!                              'left', n, 'cpu', 1, 'minutes', 5, ...
%!                              'isSent', true);
%!  for k = 1:n
%!    queueState.folder{k} = fullfile (store, num2str (k));
%!    mkdir (queueState.folder{k});
%!  end
%!endfunction
%!function queueState = lookAt (queueState, jobs, text, now)
%!  tidy = slurmFake ('false', text);
%!  queueState = pollQueue (queueState, jobs, slurmExecutor (), 30, now);
%!endfunction
%!test
%! % no answer is no evidence, however long; the user is told once
%! [f, jobs] = flightOf (2);
%! writeAtomic (fullfile (f.folder{2}, 'end.mark'), "0 1.0 finished\n");
%! f = lookAt (f, jobs, 'echo "no contact"; exit 1', 0);
%! assert (f.status, 'oe');
%! assert (! isempty (strfind (f.message, 'no contact')));
%! f.message = '';
%! f = lookAt (f, jobs, 'exit 1', 1e6);
%! assert ({f.status, f.message}, {'oe', ''});
%! f = lookAt (f, jobs, 'echo "b|1|RUNNING|None"', 1e6 + 1);
%! assert (f.status, 'oe');
%! assert (! isempty (strfind (f.message, 'again')));
%!test
%! % the grace time counts from the first word of the end
%! [f, jobs] = flightOf (2);
%! gone = 'echo "b|1|NODE_FAIL|NodeDown"; echo "b|2|TIMEOUT|TimeLimit"';
%! f = lookAt (f, jobs, gone, 100);
%! f = lookAt (f, jobs, gone, 129);
%! assert (f.status, 'oo');
%! f = lookAt (f, jobs, gone, 131);
%! assert (f.status, 'ss');
%! r = [f.records{:}];
%! assert ({r.status; r.cause}, {'failed', 'timeout'; 'killed', 'time'});
%! assert (! isempty (strfind (r(1).message, 'NODE_FAIL (NodeDown)')));
%! assert (isfile (fullfile (f.folder{1}, 'batch.claim', 'void')));
%! assert (isfile (fullfile (f.folder{1}, 'record.json')));
%!test
%! % why nothing runs is said once
%! [f, jobs] = flightOf (2);
%! f = lookAt (f, jobs, 'printf "b|%d|PENDING|Resources\n" 1 2', 0);
%! assert (! isempty (strfind (f.message, '2 run(s)')));
%! f.message = '';
%! f = lookAt (f, jobs, 'printf "b|%d|PENDING|Resources\n" 1 2', 0);
%! assert (f.message, '');
%!test
%! % end mark, state in the queue, for how long ended (s), is it of an earlier
%! % start; what becomes of it: open, to evaluate, failed, timeout, to queue.
%! % The queue may believe in a job whose keeper was killed
%! cases = {'finished', 'RUNNING', 0, false, 'e'; ...
%!          'timeout', 'FAILED', 0, true, 'e'; ...
%!          '', 'RUNNING', 1e6, false, 'o'; '', 'PENDING', 1e6, true, 'o'; ...
%!          '', 'FAILED', 29, false, 'o'; '', 'FAILED', 30, false, 'f'; ...
%!          '', '', 29, true, 'o'; '', '', 30, true, 'q'; ...
%!          '', 'TIMEOUT', 30, false, 't'; ...
%!          'killed', 'RUNNING', 1, false, 'o'; ...
%!          'killed', 'RUNNING', 30, false, 'f'; ...
%!          'killed', 'FAILED', 0, false, 'f'; ...
%!          'killed', 'FAILED', 0, true, 'q'; ...
%!          'killed', 'TIMEOUT', 0, true, 't'};
%! [f, jobs] = flightOf (rows (cases));
%! f.since = -[cases{:, 3}];
%! f.isOld = [cases{:, 4}];
%! said = '';
%! for k = 1:rows (cases)
%!   if ~isempty (cases{k, 1})
%!     writeAtomic (fullfile (f.folder{k}, 'end.mark'), ...
%!                  sprintf ("1 1.0 %s\n", cases{k, 1}));
%!   end
%!   said = [said, repmat(sprintf ("echo 'b|%d|%s|'\n", k, cases{k, 2}), 1, ...
%!                        ~isempty (cases{k, 2}))];
%! end
%! f = lookAt (f, jobs, said, 0);
%! became = f.status;
%! became(became == 's') = cellfun (@(r) r.status(1), f.records(became == 's'));
%! assert (became, [cases{:, 5}]);

% SPDX-License-Identifier: GPL-3.0-only
