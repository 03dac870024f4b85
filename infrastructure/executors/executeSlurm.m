% EXECUTESLURM  Carries out runs on a cluster, as job arrays of Slurm.
%
% CALL: RECORDS = executeSlurm (JOBS, CASE, REPORT)
%
%   JOBS     1 x n struct array, see newJobs
%   CASE     see newCase; CASE.options.slurm as in slurmOptions. The cluster
%            decides how much runs at a time, not CASE.options.maxCPU
%   REPORT   function handle, called with the state when it has changed: total,
%            done, failed, running, pending, seconds, message ('' or a text for
%            the user)
%   RECORDS  1 x n struct array, see newRecord
%
% Each run is done by guard.sh on a node of the cluster and leaves an end mark
% in its folder; Slurm is asked only for what left none. When this function is
% left early (Ctrl-C, an error, kill -9), what is in the queue stays there. The
% next call with the same jobs takes it up again: nothing is submitted twice,
% nothing that has ended is repeated. slurmCancel empties the queue.
%
% Errors: DEcalioc:executeSlurm:missingFile    no Slurm on this machine
%         DEcalioc:executeSlurm:submitRefused  partition, account, limits ...
%         those of slurmOptions and prepareRun
%
% See also: runJobs, executeLocal, slurmCancel, slurmAttach

function records = executeSlurm (jobs, Case, report)
  opt = slurmOptions (Case.options.slurm);
  opt.arraySize = askCluster ();
  watch = tic ();
  flight = slurmAttach (jobs, Case.store);
  told = struct ();
  while true
    flight = slurmLook (flight, jobs, opt, toc (watch));
    flight = collect (flight, jobs, Case);
    flight = launch (flight, jobs, Case, opt);
    state = stateOf (flight);
    state.message = flight.message;
    if ~isequal (state, told)
      told = state;
      told.message = '';
      state.seconds = toc (watch);
      report (state);
      flight.message = '';
    end
    if all (flight.status == 's')
      break
    end
    pause (opt.poll);
  end
  records = [flight.records{:}];
end

function flight = collect (flight, jobs, Case)
  ended = find (flight.status == 'e');
  if ~isempty (ended)
    found = collectRuns (jobs(ended), flight.folder(ended), Case);
    flight.records(ended) = num2cell (found);
    flight.status(ended) = 's';
    setLimits (flight, jobs, Case);
  end
  flight = slurmRetire (flight);
end

function setLimits (flight, jobs, Case)
  done = [flight.records{:}];
  for model = Case.models
    limit = defaultLimit (model, done);
    isOpen = flight.status == 'o' & strcmp ({jobs.model}, model.name);
    for i = find (isOpen & ~isnan (limit))
      most = 60 * flight.batches(flight.batch(i)).minutes - 10;
      writeAtomic (fullfile (flight.folder{i}, 'limit'), ...
                   sprintf ("%d\n", floor (min (limit, most))));
    end
  end
end

% Fills the queue up to maxInFlight, a quarter of it at least at a time.
function flight = launch (flight, jobs, Case, opt)
  flight = send (flight, opt, Case.root);
  queue = find (flight.status == 'q');
  free = opt.maxInFlight - sum (flight.status == 'o');
  isWorth = free >= min (numel (queue), ceil (opt.maxInFlight / 4));
  if isempty (queue) || ~isWorth || ~all ([flight.batches.isSent])
    return
  end
  picks = queue(1:min (numel (queue), floor (free)));
  [~, k] = ismember ({jobs(picks).model}, {Case.models.name});
  cpus = [Case.models(k).cpu];
  for cpu = unique (cpus)
    same = picks(cpus == cpu);
    for first = 1:opt.arraySize:numel (same)
      part = same(first:min (numel (same), first + opt.arraySize - 1));
      flight = slurmSubmit (flight, part, jobs, Case, opt);
      flight = send (flight, opt, Case.root);
    end
  end
end

function flight = send (flight, opt, root)
  for b = find (~[flight.batches.isSent])
    [verdict, text] = slurmSend (flight.batches(b), opt, root);
    isAlone = ~any (flight.status == 'o' & flight.batch ~= b);
    flight.batches(b).isSent = strcmp (verdict, 'sent');
    if strcmp (verdict, 'refused') && isAlone
      flight = slurmRetire (flight, b);
      error ('DEcalioc:executeSlurm:submitRefused', ...
             ['executeSlurm: Slurm must accept %d job(s), got: %s. ' ...
              'Correct Input.slurm (where there is a limit on the number ' ...
              'of jobs: maxInFlight) and start again.'], ...
             flight.batches(b).n, text);
    elseif ~strcmp (verdict, 'sent') && ~strcmp (text, flight.waitsFor)
      flight.waitsFor = text;
      flight.message = ['Slurm takes no jobs now, trying on: ', text];
    end
  end
end

% Tasks that one array may have: the highest index is one less than Slurm's
% MaxArraySize. A controller that does not answer is waited for later.
function n = askCluster ()
  [status, text] = system (['command -v sbatch && command -v squeue && ' ...
                            'timeout 60 scontrol show config 2>&1']);
  isAbsent = isempty (regexp (text, '/squeue\s', 'once'));
  if isAbsent || ~isempty (strfind (text, 'configuration source'))
    error ('DEcalioc:executeSlurm:missingFile', ...
           ['executeSlurm: this machine must belong to a Slurm cluster, ' ...
            'got: %s. Start on a machine where squeue works, or set ' ...
            'Input.executor = ''local''.'], ...
           [strtrim(text), repmat('no sbatch on the PATH', 1, isAbsent)]);
  end
  found = regexp (text, 'MaxArraySize\s*=\s*(\d+)', 'tokens', 'once');
  n = 1000;
  if status == 0 && ~isempty (found)
    n = max (1, str2double (found{1}) - 1);
  end
end

function state = stateOf (flight)
  isOpen = flight.status == 'o';
  status = cellfun (@(r) r.status, flight.records(flight.status == 's'), ...
                    'UniformOutput', false);
  running = sum (isOpen & strcmp (flight.state, 'RUNNING'));
  state = struct ('total', numel (isOpen), 'done', numel (status), ...
                  'failed', sum (~strcmp (status, 'ok')), ...
                  'running', running, 'pending', sum (isOpen) - running);
end
