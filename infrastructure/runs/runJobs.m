% RUNJOBS  Carries out jobs; what is in the store is not run again.
%
% CALL: [RECORDS, ISREUSED, NNEW] = runJobs (JOBS, CASE, REPORT)
%
%   JOBS     1 x n struct array, see newJobs
%   CASE     see newCase; CASE.options.executor names the executor
%   REPORT   function handle, called as REPORT (STATE) with the fields total,
%            done, failed, running, reused, seconds
%   RECORDS  1 x n struct array, see newRecord, in the order of JOBS
%   ISREUSED  1 x n logical: the run was in the store
%   NNEW     runs that were made
%
% A run that was killed from outside is tried again as it is, up to twice, and
% counts once. A run that failed by itself is tried once more with another seed,
% since an unlucky packing may be the cause. What then still fails is a record
% that says so.
%
% At most CASE.options.maxNewRuns runs are made, those with another seed among
% them; a job beyond them is a failed record with the cause 'budget'.

function [records, isReused, nNew] = runJobs (jobs, Case, report)
  for k = 1:numel (Case.models)
    Case.models(k).funs = hashEvaluation (Case.models(k));
  end
  records = repmat (newRecord (jobs(1), ''), 1, numel (jobs));
  [records, open] = fromStore (jobs, records, Case);
  isReused = ~open;
  execute = executorOf (Case);
  tell = @(state) report (setfield (state, 'reused', sum (isReused)));
  if ~any (open)
    tell (struct ('total', 0, 'done', 0, 'failed', 0, 'running', 0));
  end
  overBudget = open & cumsum (open) > Case.options.maxNewRuns;
  records(overBudget) = withoutRun (records(overBudget));
  open = open & ~overBudget;
  [records, open] = carryOut (jobs, records, open, Case, tell);
  nNew = sum (open);
  for attempt = 1:2
    again = open & strcmp ({records.cause}, 'killed');
    if any (again)
      records(again) = execute (jobs(again), Case, tell);
    end
  end
  Case.models = addSeconds (Case.models, records(open));
  Case.options.maxNewRuns = Case.options.maxNewRuns - nNew;
  [records, nSecond] = withOtherSeed (jobs, records, Case, execute, tell);
  nNew = nNew + nSecond;
end

% What another case on the same store is about to run is waited for. ISMADE:
% runs that were made here.
function [records, isMade] = carryOut (jobs, records, open, Case, tell)
  execute = executorOf (Case);
  isMade = false (size (open));
  while any (open)
    waiting = find (open);
    [isMine, hold] = claimRuns (jobs(waiting), Case);
    mine = waiting(isMine);
    if ~isempty (mine)
      records(mine) = execute (jobs(mine), Case, tell);
    end
    hold = {};
    isMade(mine) = true;
    open(mine) = false;
    if any (open)
      pause (1);
      [records(open), open(open)] = fromStore (jobs(open), records(open), Case);
    end
  end
end

function execute = executorOf (Case)
  execute = describeExecutor (Case.options.executor).execute;
end

function records = withoutRun (records)
  for i = 1:numel (records)
    records(i).cause = 'budget';
    records(i).message = 'not run: Input.maxNewRuns is reached';
  end
end

function [records, open] = fromStore (jobs, records, Case)
  found = findRuns (jobs, Case);
  open = cellfun (@isempty, found);
  stale = false (size (open));
  for i = find (~open)
    r = found{i};
    again = {'failed', 'timeout', 'forgotten'};
    if isfield (r, 'status') && any (strcmp (r.status, again))
      open(i) = true;
    elseif ~isfield (r, 'funs') || ...
           ~strcmp (r.funs, funsOf (jobs(i).model, Case))
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

function key = funsOf (model, Case)
  key = Case.models(strcmp (model, {Case.models.name})).funs;
end

% A stored run may have been made for another stage or row of the plan.
function record = takeOver (record, stored, job)
  for name = intersect (fieldnames (record), fieldnames (stored))'
    record.(name{1}) = stored.(name{1});
  end
  record.stage = job.stage;
  record.planRow = job.planRow;
end

function [records, nNew] = withOtherSeed (jobs, records, Case, execute, tell)
  failed = find (~strcmp ({records.status}, 'ok') & ...
                 ~ismember ({records.cause}, {'killed', 'budget'}));
  nNew = 0;
  if isempty (failed)
    return
  end
  other = jobs(failed);
  h = hashModels (Case);
  for i = 1:numel (other)
    k = strcmp (other(i).model, {Case.models.name});
    other(i).seed = runSeed (other(i).params, other(i).replicate + 0.5, ...
                             Case.options.seed);
    [other(i).key, ~, other(i).variables] = ...
      runKey (runVariables (other(i), Case), Case.effectVars, h(k));
  end
  [second, open] = fromStore (other, records(failed), Case);
  open = open & cumsum (open) <= Case.options.maxNewRuns;
  nNew = sum (open);
  if any (open)
    second(open) = execute (other(open), Case, tell);
  end
  cured = strcmp ({second.status}, 'ok');
  records(failed(cured)) = second(cured);
end

%!shared quiet
%! quiet = @(state) [];
%!test
%! % a second call finds all runs, whatever the stage and the row
%! Case = newCase (standInCase (tempname ()));
%! jobs = newJobs (Case, [1, 2; 3, 4], [], 1, 'plan');
%! first = runJobs (jobs, Case, quiet);
%! [second, isReused] = runJobs (newJobs (Case, [3, 4; 1, 2], [], 1, ...
%!                                        'verify'), Case, quiet);
%! assert (all (isReused));
%! assert ({second.folder}, {first([3, 4, 1, 2]).folder});
%! assert (second(1).results, first(3).results);
%! assert (second(1).stage, 'verify');
%!test
%! % a change in getResults asks for a new evaluation, not for a new run
%! Case = newCase (standInCase (tempname ()));
%! jobs = newJobs (Case, [1, 2], [], 1, 'plan')(2);
%! runJobs (jobs, Case, quiet);
%! file = fullfile (Case.models(2).folder, 'OctaveFuns', 'getResults.m');
%! text = fileread (file);
%! pause (1.1);
%! writeAtomic (file, strrep (text, '(load (file)'')', ...
%!                            '(100 * load (file)'')'));
%! r = runJobs (jobs, Case, quiet);
%! assert (r.results, -100, 1e-12);
%! assert (numel (listRunFolders (Case.store, 'Second')), 1);
%!test
%! % a run that was killed is run again as it is, and counts once
%! Case = newCase (standInCase (tempname ()));
%! run = fullfile (Case.models(2).folder, 'runscript');
%! flag = tempname ();
%! writeAtomic (run, ["[ -e ", flag, " ] || { touch ", flag, ...
%!                    "; kill -9 $$; }\n", fileread(run)]);
%! job = newJobs (Case, [1, 2], [], 1, 'plan')(2);
%! r = runJobs (job, Case, quiet);
%! assert (r.status, 'ok');
%! assert (r.key, job.key);
%! unlink (flag);
%!test
%! % the second start finds the run with the other seed as well
%! Case = newCase (standInCase (tempname ()));
%! run = fullfile (Case.models(2).folder, 'runscript');
%! job = newJobs (Case, [1, 2], [], 1, 'plan')(2);
%! spoil = sprintf ('grep -q %d data.head && echo nan > out', job.seed);
%! writeAtomic (run, [strtrim(fileread (run)), "\n", spoil, "\n:\n"]);
%! job = newJobs (Case, [1, 2], [], 1, 'plan')(2);
%! r = runJobs (job, Case, quiet);
%! assert (r.status, 'ok');
%! assert (r.seed != job.seed);
%! again = runJobs (job, Case, quiet);
%! assert (again.folder, r.folder);
%! assert (numel (listRunFolders (Case.store, 'Second')), 2);
%!test
%! % a finished simulation whose record was lost is evaluated, not repeated
%! Case = newCase (standInCase (tempname ()));
%! job = newJobs (Case, [1, 2], [], 1, 'plan')(1);
%! r = runJobs (job, Case, quiet);
%! writeAtomic (fullfile (r.folder, 'record.json'), 'torn');
%! again = runJobs (job, Case, quiet);
%! assert (again.folder, r.folder);
%! assert (again.results, r.results);
%!test
%! % two cases that point at one store share its runs
%! raw = standInCase (tempname ());
%! Case = newCase (raw);
%! jobs = newJobs (Case, [1, 2], [], 1, 'plan');
%! first = runJobs (jobs, Case, quiet);
%! other = standInCase (tempname ());
%! other.Input.store = raw.folder;
%! Case = newCase (other);
%! [second, isReused] = runJobs (newJobs (Case, [1, 2], [], 1, 'plan'), ...
%!                               Case, quiet);
%! assert (all (isReused));
%! assert ({second.folder}, {first.folder});
%!test
%! % tries with another seed are runs too; a job that has none left stays failed
%! Case = newCase (standInCase (tempname ()));
%! writeAtomic (fullfile (Case.models(2).folder, 'runscript'), "exit 1\n");
%! Case.options.maxNewRuns = 5;
%! [r, ~, nNew] = runJobs (newJobs (Case, [1, 2; 3, 4], [], 1, 'plan'), ...
%!                         Case, quiet);
%! assert ({r.status}, {'ok', 'failed', 'ok', 'failed'});
%! assert (nNew, 5);
%! assert (numel (listRunFolders (Case.store, 'Second')), 3);
