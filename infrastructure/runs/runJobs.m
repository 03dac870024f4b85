% RUNJOBS  Carries out jobs; what is in the store is not run again.
%
% CALL: RECORDS = runJobs (JOBS, CASE, REPORT)
%
%   JOBS     1 x n struct array, see newJobs
%   CASE     see newCase; CASE.options.executor names the executor
%   REPORT   function handle, called as REPORT (STATE) with the fields total,
%            done, failed, running, reused, seconds
%   RECORDS  1 x n struct array, see newRecord, in the order of JOBS
%
% A run that was killed from outside is tried again as it is, up to twice. A
% run that failed by itself is tried once more with another seed, since an
% unlucky packing may be the cause. What then still fails is a record that
% says so.
%
% See also: findRuns, executeLocal, executeSlurm

function records = runJobs (jobs, Case, report)
  records = repmat (newRecord (jobs(1), ''), 1, numel (jobs));
  [records, open] = fromStore (jobs, records, Case);
  reused = numel (jobs) - sum (open);
  execute = str2func (['execute', upper(Case.options.executor(1)), ...
                       Case.options.executor(2:end)]);
  tell = @(state) report (withReused (state, reused));
  if any (open)
    records(open) = execute (jobs(open), Case, tell);
  else
    tell (struct ('total', 0, 'done', 0, 'failed', 0, 'running', 0));
  end
  for attempt = 1:2
    again = open & strcmp ({records.cause}, 'killed');
    if any (again)
      records(again) = execute (jobs(again), Case, tell);
    end
  end
  records = withOtherSeed (jobs, records, Case, execute, tell);
end

function state = withReused (state, reused)
  state.reused = reused;
end

function [records, open] = fromStore (jobs, records, Case)
  found = findRuns (jobs, Case);
  open = cellfun (@isempty, found);
  funs = struct ();
  for k = 1:numel (Case.models)
    funs.(Case.models(k).name) = ...
      hashFolder (fullfile (Case.models(k).folder, 'OctaveFuns'), {});
  end
  stale = false (size (open));
  for i = find (~ open)
    r = found{i};
    if isfield (r, 'status') && any (strcmp (r.status, {'failed', 'timeout'}))
      open(i) = true;
    elseif ~ isfield (r, 'funs') || ~ strcmp (r.funs, funs.(jobs(i).model))
      stale(i) = true;
    else
      records(i) = takeOver (records(i), r, jobs(i));
    end
  end
  if any (stale)
    folders = cellfun (@(r) r.folder, found(stale), 'UniformOutput', false);
    records(stale) = collectRuns (jobs(stale), folders, Case);
  end
end

% A stored run may have been made for another stage or row of the plan.
function record = takeOver (record, stored, job)
  names = fieldnames (record);
  for k = 1:numel (names)
    record.(names{k}) = stored.(names{k});
  end
  record.stage = job.stage;
  record.planRow = job.planRow;
end

function records = withOtherSeed (jobs, records, Case, execute, tell)
  failed = find (~ strcmp ({records.status}, 'ok') & ...
                 ~ strcmp ({records.cause}, 'killed'));
  if isempty (failed)
    return;
  end
  other = jobs(failed);
  h = hashModels (Case);
  for i = 1:numel (other)
    k = strcmp (other(i).model, {Case.models.name});
    other(i).seed = runSeed (other(i).params, other(i).replicate + 0.5, ...
                             Case.options.seed);
    other(i).key = runKey (runVariables (other(i), Case), ...
                           Case.effectVars, h(k));
  end
  second = repmat (records(1), 1, numel (other));
  [second, open] = fromStore (other, second, Case);
  if any (open)
    second(open) = execute (other(open), Case, tell);
  end
  cured = strcmp ({second.status}, 'ok');
  records(failed(cured)) = second(cured);
end
