% SLURMLOOK  Looks once at the queue and at the end marks of all open runs.
%
% CALL: FLIGHT = slurmLook (FLIGHT, JOBS, OPT, NOW)
%
%   FLIGHT  see slurmAttach; runs that have ended become 'e' (to be evaluated),
%           's' (record made here: killed, cancelled, node lost, Slurm's time
%           limit) or 'q' (to be submitted again)
%   JOBS    1 x n struct array, see newJobs
%   OPT     see slurmOptions
%   NOW     time (s)
%
% See also: slurmJudge, slurmQueue

function flight = slurmLook (flight, jobs, opt, now)
  used = unique (flight.batch(flight.status == 'o'));
  used = used([flight.batches(used).isSent]);
  if isempty (used)
    return
  end
  [ok, text] = slurmQueue ({flight.batches(used).name});
  flight = noteSilence (flight, ok, text);
  for b = used
    open = find (flight.status == 'o' & flight.batch == b);
    if ok
      [states, reasons] = slurmParse (text, flight.batches(b).name, ...
                                      flight.batches(b).n);
    else
      states = repmat ({'UNREACHABLE'}, 1, flight.batches(b).n);
      reasons = states;
    end
    for i = open
      said = struct ('state', states{flight.task(i)}, ...
                     'why', reasons{flight.task(i)}, 'ok', ok, 'now', now);
      flight = lookAtRun (flight, i, jobs(i), said, opt.grace);
    end
  end
  flight = noteWaiting (flight);
end

function flight = lookAtRun (flight, i, job, said, grace)
  folder = flight.folder{i};
  flight.state{i} = said.state;
  flight.why{i} = said.why;
  mark = readEndMark (folder);
  reason = '';
  if ~isempty (mark)
    reason = mark.reason;
  end
  hasEnded = ~slurmIsLive (said.state) || strcmp (reason, 'killed');
  if ~(hasEnded && said.ok)
    flight.since(i) = NaN;
  elseif isnan (flight.since(i))
    flight.since(i) = said.now;
  end
  age = max ([0, said.now - flight.since(i)]);
  verdict = slurmJudge (reason, said.state, age, grace, flight.isOld(i));
  switch verdict
    case 'collect'
      flight.status(i) = 'e';
    case 'again'
      slurmVoid (folder);
      flight.status(i) = 'q';
    case {'failed', 'timeout'}
      slurmVoid (folder);
      causes = struct ('failed', 'killed', 'timeout', 'time');
      flight.records{i} = failedRecord (job, folder, verdict, ...
                                        describe (flight, i), ...
                                        causes.(verdict));
      flight.status(i) = 's';
  end
end

function text = describe (flight, i)
  state = flight.state{i};
  if isempty (state)
    state = 'the job is no longer known';
  end
  text = ['Slurm: ', state];
  if ~any (strcmp (flight.why{i}, {'', 'None'}))
    text = sprintf ('%s (%s)', text, flight.why{i});
  end
  who = contentOf (fullfile (flight.folder{i}, 'slurm.claim', 'who'));
  if isempty (who)
    who = [flight.batches(flight.batch(i)).name, ', never started'];
  end
  said = contentOf (fullfile (flight.batches(flight.batch(i)).path, ...
                              sprintf ('%d.out', flight.task(i))));
  text = strtrim (sprintf ('%s, job %s; %s', text, who, ...
                           said));
end

function text = contentOf (file)
  text = '';
  fid = fopen (file, 'r');
  if fid >= 0
    text = strtrim (fread (fid, [1, 500], 'uint8=>char'));
    fclose (fid);
  end
end

function flight = noteSilence (flight, ok, text)
  if ~ok && ~flight.silent
    flight.message = sprintf (['The Slurm controller does not answer (%s). ' ...
                               'Waiting; the runs go on.'], strtrim (text));
  elseif ok && flight.silent
    flight.message = 'The Slurm controller answers again.';
  end
  flight.silent = ~ok;
end

% Tells, once for each reason, why nothing runs.
function flight = noteWaiting (flight)
  isOpen = flight.status == 'o';
  isWaiting = isOpen & strcmp (flight.state, 'PENDING');
  why = '';
  if any (isWaiting) && ~any (isOpen & strcmp (flight.state, 'RUNNING'))
    reasons = flight.why(isWaiting);
    why = reasons{1};
  end
  if ~any (strcmp (why, {'', 'None', flight.waitsFor}))
    flight.message = sprintf ('%d run(s) wait in the queue of Slurm: %s', ...
                              sum (isWaiting), why);
    flight.waitsFor = why;
  end
end

%!function [flight, jobs] = flightOf (n)
%!  store = tempname ();
%!  mkdir (store);
%!  jobs = struct ('model', 'M', 'stage', 'plan', 'planRow', 1, 'params', 1, ...
%!                 'effects', [], 'replicate', 1, 'seed', 10007, ...
%!                 'key', num2cell (sprintf ('%d', 1:n)));
%!  flight = slurmAttach (jobs, store);
%!  flight.status(:) = 'o';
%!  flight.batch(:) = 1;
%!  flight.task = 1:n;
%!  flight.batches(1) = struct ('name', 'b', 'path', store, 'n', n, ...
%!                              'left', n, 'cpu', 1, 'minutes', 5, ...
%!                              'isSent', true);
%!  for k = 1:n
%!    flight.folder{k} = fullfile (store, num2str (k));
%!    mkdir (flight.folder{k});
%!  end
%!endfunction
%!function flight = lookAt (flight, jobs, text, now)
%!  tidy = slurmFake ('false', text);
%!  flight = slurmLook (flight, jobs, slurmOptions ([]), now);
%!endfunction
%!function remove (flight)
%!  confirm_recursive_rmdir (false, 'local');
%!  rmdir (flight.batches.path, 's');
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
%! remove (f);
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
%! assert (isfile (fullfile (f.folder{1}, 'slurm.claim', 'void')));
%! assert (isfile (fullfile (f.folder{1}, 'record.json')));
%! remove (f);
%!test
%! % cancelled while nobody looked: submitted again
%! [f, jobs] = flightOf (1);
%! f.isOld(:) = true;
%! f = lookAt (f, jobs, 'true', 0);
%! f = lookAt (f, jobs, 'true', 31);
%! assert (f.status, 'q');
%! remove (f);
%!test
%! % why nothing runs is said once
%! [f, jobs] = flightOf (2);
%! f = lookAt (f, jobs, 'printf "b|%d|PENDING|Resources\n" 1 2', 0);
%! assert (! isempty (strfind (f.message, '2 run(s)')));
%! f.message = '';
%! f = lookAt (f, jobs, 'printf "b|%d|PENDING|Resources\n" 1 2', 0);
%! assert (f.message, '');
%! remove (f);
