% RUNJOBS  Carries out jobs; what is in the store is not run again.
%
% CALL: [RECORDS, ISREUSED, NNEW, MODELS] = runJobs (JOBS, CASE, REPORT)
%
%   JOBS     1 x n struct array, see newJobs
%   CASE     see newCase; CASE.options.executor names the executor
%   REPORT   function handle, called as REPORT (STATE) with the fields total,
%            done, failed, running, reused, seconds
%   RECORDS  1 x n struct array, see newRecord, in the order of JOBS
%   ISREUSED  1 x n logical: the run was in the store
%   NNEW     runs that were made
%   MODELS   CASE.models, which knows how long RECORDS took (addSeconds)
%
% A run that was killed from outside is tried again as it is, up to twice, and
% counts once. A run that failed by itself is tried once more with another seed,
% since an unlucky packing may be the cause, with twice the time where it was cut
% off at a limit that was learned (defaultLimit); not where getResults gave an
% error: once that is corrected, the run that there is gets evaluated; nor where it
% found no number, as in a slot that clogs: the packings that flow would stand for
% all. What then still fails is a record that says so. In the place of a run that the user has
% taken out of use (decalioc forget) one with another seed is made.
%
% A model may start from the last state of another one (stagesOf): that is run
% first, once for a set and a packing, and is a run of the store like any other.
% One that fails takes with it what starts from it (cause 'stage').
%
% At most CASE.options.maxNewRuns runs are made, those with another seed among
% them; a job beyond them is a failed record with the cause 'budget'. A stage that
% is no model of the case is part of the runs that start from it.

function [records, isReused, nNew, models] = runJobs (jobs, Case, report)
  models = Case.models;
  Case.hashes = hashModels (Case);
  Case = withStages (Case);
  caseId (Case.folder, true);           % before the workers ask for it
  records = repmat (newRecord (jobs(1), ''), 1, numel (jobs));
  [records, open, jobs] = fromStore (jobs, records, Case);
  isReused = ~open;
  show = @(state) report (setfield (state, 'reused', sum (isReused)));
  if ~any (open)
    show (struct ('total', 0, 'done', 0, 'failed', 0, 'running', 0));
  end
  overBudget = open & cumsum (open) > Case.options.maxNewRuns;
  [records(overBudget).cause] = deal ('budget');
  [records(overBudget).message] = ...
    deal ('not run: Input.maxNewRuns is reached');
  open = open & ~overBudget;
  [records, open] = carryOut (jobs, records, open, Case, show);
  nNew = sum (open);
  for attempt = 1:2
    again = open & strcmp ({records.cause}, 'killed');
    if any (again)
      records(again) = execute (jobs(again), Case, show);
    end
  end
  Case.models = addSeconds (Case.models, records(open));
  Case.options.maxNewRuns = Case.options.maxNewRuns - nNew;
  [records, nSecond] = withOtherSeed (jobs, records, Case, show);
  nNew = nNew + nSecond;
  models = addSeconds (models, records);
end

% What another case on the same store is about to run is waited for, as long as
% Input.waitHours says. ISMADE: runs that were made here.
function [records, isMade] = carryOut (jobs, records, open, Case, show)
  isMade = false (size (open));
  wait = struct ('number', 0, 'since', time (), 'said', -Inf);
  note = fullfile (Case.folder, 'decalioc.waits');
  tidy = onCleanup (@() nthargout (1, @unlink, note));
  for model = unique ({jobs(open).model})
    tidyDrafts (runPlace (Case, model{1}));
  end
  while any (open)
    waiting = find (open);
    [isMine, hold, holder] = claimRuns (jobs(waiting), Case);
    if time () - wait.since > 3600 * Case.options.waitHours
      isMine(:) = true;                    % it may be suspended
    end
    mine = waiting(isMine);
    if ~isempty (mine)
      records(mine) = execute (jobs(mine), Case, show);
    end
    hold = {};
    isMade(mine) = true;
    open(mine) = false;
    if any (open)
      wait = waitForRuns (wait, sum (open), holder, Case, show);
      [records(open), open(open)] = fromStore (jobs(open), records(open), Case);
    end
  end
end

% A run that starts from the state of others (stagesOf) waits for them.
function records = execute (jobs, Case, show)
  [jobs.starts] = deal ({});
  records = repmat (newRecord (jobs(1), ''), 1, numel (jobs));
  stages = arrayfun (@(job) stageJobs (job, Case), jobs, ...
                     'UniformOutput', false);
  needed = [stages{:}];
  isOpen = true (1, numel (jobs));
  if ~isempty (needed)
    [~, first] = unique ({needed.key}, 'first');
    needed = needed(sort (first));
    [found, places] = runStages (needed, jobs, Case, show);
    [isMade, at] = ismember ({places.key}, {jobs.key});
    records(at(isMade)) = found(isMade);
    isOpen(at(isMade)) = false;
    for i = find (isOpen & ~cellfun (@isempty, stages))
      mine = found(ismember ({needed.key}, {stages{i}.key}));
      jobs(i).starts = {mine.folder};
      [records(i), isOpen(i)] = afterStages (jobs(i), mine);
    end
  end
  if any (isOpen)
    executor = describeExecutor (Case.options.executor);
    records(isOpen) = executor.execute (jobs(isOpen), Case, show);
  end
end

% Of the models that the one of a job starts from: the same values, the same seed.
function stages = stageJobs (job, Case)
  stages = repmat (job, 1, 0);
  of = strcmp (job.model, {Case.models.name});
  for name = stagesOf (Case.models(of).folder)
    k = find (strcmp (name{1}, {Case.models.name}));
    stage = job;
    [stage.model, stage.input] = deal (name{1}, Case.hashes(k).input);
    [stage.key, stage.variables] = runKey (runVariables (stage, Case), ...
                                           Case.effectVars, Case.hashes(k));
    stages(end + 1) = stage;
  end
end

% NEEDED in the store, among JOBS or run now. PLACES: as NEEDED, but with the job
% that takes the place of a run out of use. No second try with another seed: what
% starts from it gets one, and with it another stage.
function [found, places] = runStages (needed, jobs, Case, show)
  found = repmat (newRecord (needed(1), ''), 1, numel (needed));
  [found, open, places] = fromStore (needed, found, Case);
  [isAsked, at] = ismember ({places.key}, {jobs.key});
  isAsked = isAsked & open;
  if any (isAsked)
    found(isAsked) = execute (jobs(at(isAsked)), Case, show);
  end
  rest = open & ~isAsked;
  if any (rest)
    found(rest) = carryOut (places(rest), found(rest), true (1, sum (rest)), ...
                            Case, show);
  end
end

function [record, isOpen] = afterStages (job, stages)
  record = newRecord (job, '');
  bad = find (~strcmp ({stages.status}, 'ok'), 1);
  isOpen = isempty (bad);
  if ~isOpen
    record.folder = stages(bad).folder;
    record.message = sprintf ('it starts from %s, which gave no state: %s', ...
                              stages(bad).model, stages(bad).message);
    record.cause = 'stage';
    if strcmp (stages(bad).cause, 'killed')
      record.cause = 'killed';
    end
  end
end

% JOBS: with another seed where the run was taken out of use.
function [records, open, jobs] = fromStore (jobs, records, Case)
  found = findRuns (jobs, Case);
  states = cellfun (@(r) givenField (r, 'status', ''), found, ...
                    'UniformOutput', false);
  isOut = strcmp (states, 'forgotten');
  if any (isOut)
    jobs(isOut) = arrayfun (@(job) nextPacking (job, Case), jobs(isOut));
    [records, open, jobs] = fromStore (jobs, records, Case);
    return
  end
  open = cellfun (@isempty, found) | ismember (states, {'failed', 'timeout'});
  stale = false (size (open));
  for i = find (~open)
    funs = Case.hashes(strcmp (jobs(i).model, {Case.models.name})).funs;
    stale(i) = ~strcmp (givenField (found{i}, 'funs', ''), funs);
    if ~stale(i)
      records(i) = takeOver (records(i), found{i}, jobs(i));
    end
  end
  if any (stale)
    folders = cellfun (@(r) r.folder, found(stale), 'UniformOutput', false);
    records(stale) = collectRuns (jobs(stale), folders, Case);
    open(stale) = strcmp ({records(stale).cause}, 'killed');
  end
end

% A stored run may have been made for another stage or row of the plan.
function record = takeOver (record, stored, job)
  for name = intersect (fieldnames (record), fieldnames (stored))'
    record.(name{1}) = stored.(name{1});
  end
  record.stage = job.stage;
  record.planRow = job.planRow;
end

function [records, nNew] = withOtherSeed (jobs, records, Case, show)
  failed = find (~strcmp ({records.status}, 'ok') & ...
                 ~ismember ({records.cause}, ...
                            {'killed', 'budget', 'evaluation', 'none'}));
  nNew = 0;
  if isempty (failed)
    return
  end
  other = arrayfun (@(job) nextPacking (job, Case), jobs(failed));
  [second, open, other] = fromStore (other, records(failed), Case);
  open = open & cumsum (open) <= Case.options.maxNewRuns;
  nNew = sum (open);
  if any (open)
    Case.models = morePatience (Case.models, records(failed(open)));
    second(open) = execute (other(open), Case, show);
  end
  cured = strcmp ({second.status}, 'ok');
  records(failed(cured)) = second(cured);
end

% Runs that were cut off at their limit get twice the time when they are tried
% again.
function models = morePatience (models, records)
  records = records(strcmp ({records.cause}, 'time'));
  for k = 1:numel (models)
    mine = records(strcmp ({records.model}, models(k).name));
    models(k).least = 2 * max ([mine.seconds, 0]);
  end
end

%!function [Case, jobs] = planOf (P, store)
%!  Case = readyCase ();
%!  if nargin > 1
%!    Case.store = store;
%!  end
%!  jobs = newJobs (Case, P, [], 1, 'plan');
%!endfunction
%!shared quiet
%! quiet = @(state) [];
%!test
%! % a second call finds all runs, whatever the stage and the row; so does
%! % another case that points at the same store
%! [Case, jobs] = planOf ([1, 2; 3, 4]);
%! first = runJobs (jobs, Case, quiet);
%! [second, isReused] = runJobs (newJobs (Case, [3, 4; 1, 2], [], 1, ...
%!                                        'verify'), Case, quiet);
%! assert (all (isReused));
%! assert ({second.folder}, {first([3, 4, 1, 2]).folder});
%! assert (second(1).results, first(3).results);
%! assert (second(1).stage, 'verify');
%! [other, jobs] = planOf ([1, 2], Case.folder);
%! [second, isReused] = runJobs (jobs, other, quiet);
%! assert (all (isReused));
%! assert ({second.folder}, {first(1:2).folder});
%! % a finished simulation whose record was lost is evaluated, not repeated
%! writeAtomic (fullfile (first(1).folder, 'record.json'), 'torn');
%! again = runJobs (jobs(1), Case, quiet);
%! assert ({again.folder, again.results}, {first(1).folder, first(1).results});
%!test
%! % a change in getResults asks for a new evaluation, not for a new run
%! [Case, jobs] = planOf ([1, 2]);
%! runJobs (jobs(2), Case, quiet);
%! file = fullfile (Case.models(2).folder, 'OctaveFuns', 'getResults.m');
%! pause (1.1);
%! writeAtomic (file, strrep (fileread (file), '(load (file)'')', ...
%!                            '(100 * load (file)'')'));
%! assert (runJobs (jobs(2), Case, quiet).results, -100, 1e-12);
%! assert (numel (listRunFolders (Case.store, 'Second')), 1);
%!test
%! % a run that was killed is run again as it is, and counts once
%! Case = planOf ([1, 2]);
%! run = fullfile (Case.models(2).folder, 'runscript');
%! flag = tempname ();
%! writeAtomic (run, ["[ -e ", flag, " ] || { touch ", flag, ...
%!                    "; kill -9 $$; }\n", fileread(run)]);
%! job = newJobs (Case, [1, 2], [], 1, 'plan')(2);
%! r = runJobs (job, Case, quiet);
%! assert ({r.status, r.key}, {'ok', job.key});
%! % so is one that nobody has evaluated yet
%! job = newJobs (Case, [3, 2], [], 1, 'plan')(2);
%! folder = prepareRun (job, Case);
%! writeAtomic (fullfile (folder, 'end.mark'), "143 1.0 finished\n");
%! assert (runJobs (job, Case, quiet).results, 1, 1e-12);
%!test
%! % the second start finds the run with the other seed as well
%! [Case, jobs] = planOf ([1, 2]);
%! run = fullfile (Case.models(2).folder, 'runscript');
%! checks = 'spheresStart,10\nspheresOut,4\nspheresEnd,6\nsettled,1\noverlapMax,0.118\n';
%! spoil = sprintf ('grep -q %d data.head && echo nan > out && printf ''%s'' > %s', ...
%!                  jobs(2).seed, checks, 'output_checks.csv');
%! writeAtomic (run, [strtrim(fileread (run)), "\n", spoil, "\n:\n"]);
%! job = newJobs (Case, [1, 2], [], 1, 'plan')(2);
%! r = runJobs (job, Case, quiet);
%! assert (r.status, 'ok');
%! assert (r.seed != job.seed);
%! assert (runJobs (job, Case, quiet).folder, r.folder);
%! assert (numel (listRunFolders (Case.store, 'Second')), 2);
%! % without a number, and no fault, it is an outcome: no other packing stands in for it
%! writeAtomic (run, strrep (fileread (run), 'printf', 'true'));
%! job = newJobs (Case, [1, 2], [], 2, 'plan')(2);
%! writeAtomic (run, strrep (fileread (run), num2str (jobs(2).seed), num2str (job.seed)));
%! r = runJobs (job, Case, quiet);
%! assert ({r.cause, r.seed}, {'none', job.seed});
%!test
%! % tries with another seed are runs too; a job that has none left stays failed
%! Case = planOf ([1, 2]);
%! writeAtomic (fullfile (Case.models(2).folder, 'runscript'), "exit 1\n");
%! Case.options.maxNewRuns = 5;
%! [r, ~, nNew] = runJobs (newJobs (Case, [1, 2; 3, 4], [], 1, 'plan'), ...
%!                         Case, quiet);
%! assert ({r.status}, {'ok', 'failed', 'ok', 'failed'});
%! assert (nNew, 5);
%! assert (numel (listRunFolders (Case.store, 'Second')), 3);
%!test
%! % a run that another makes meanwhile is waited for, and not made again
%! Case = planOf ([1, 2], tempname ());
%! file = fullfile (Case.folder, 'case.mat');
%! writeAtomic (fullfile (Case.models(1).folder, 'runscript'), ...
%!   ["touch ", file, ".on; sleep 3\n", ...
%!    fileread(fullfile (Case.models(1).folder, 'runscript'))]);
%! job = newJobs (Case, [1, 2], [], 1, 'plan')(1);
%! save ('-binary', file, 'Case', 'job');
%! code = sprintf (['addpath (''%s''); startToolbox (''%s''); ', ...
%!                  'load (''%s''); runJobs (job, Case, @(s) []);'], ...
%!                 fullfile (Case.root, 'infrastructure'), Case.root, file);
%! system (['octave-cli --norc --eval ', shellQuote(code), ...
%!          ' > /dev/null 2>&1 &']);
%! waitUntil (@() isfile ([file, '.on']));
%! [r, ~, nNew] = runJobs (job, Case, @(s) []);
%! assert ({r.status, nNew}, {'ok', 0});
%! assert (numel (listRunFolders (Case.store, 'First')), 1);
%! % the other one lets go of it after its record is there
%! waitUntil (@() isempty (glob (fullfile (Case.store, 'optim', 'First', 'claim*'))));
%!test
%! % a stage: run once for a set and a packing, for both that start from it; found
%! % again; one that fails is named, and another packing of it is tried
%! Case = readyCase ();
%! place = fullfile (Case.folder, 'DEMmodels');
%! put = @(name, text) writeAtomic (fullfile (place, name), text);
%! [~, ~] = mkdir (fullfile (place, 'Fill'));
%! put ('Fill/data.head', "variable a equal 1\n");
%! put ('Fill/runscript', ["awk '$2 == \"a\" { a = $4 } $2 == \"runSeed\" ", ...
%!      "{ s = $4 } END { if (a > 5) exit 3; print a, s }' data.head > state\n"]);
%! for name = {'First', 'Second'}
%!   put ([name{1}, '/startsFrom'], 'Fill');
%!   put ([name{1}, '/runscript'], ...
%!        [fileread(fullfile (place, name{1}, 'runscript')), ...
%!         "cp Fill/state seen\n"]);
%! end
%! jobs = newJobs (Case, [1, 2; 3, 4; 6, 1], [], 1, 'plan');
%! [r, ~, nNew] = runJobs (jobs, Case, quiet);
%! assert ({r.status}, [repmat({'ok'}, 1, 4), repmat({'failed'}, 1, 2)]);
%! assert (nNew, 8);
%! assert (r(3).results, [7, 12], 1e-12);
%! assert (load (fullfile (r(3).folder, 'seen')), [3, r(3).seed]);
%! assert (~isempty (strfind (r(5).message, 'from Fill, which gave no state: exit')));
%! assert (r(5).cause, 'stage');
%! assert (numel (listRunFolders (Case.store, 'Fill')), 4);
%! [~, isReused, nNew] = runJobs (jobs(1:4), Case, quiet);
%! assert (isReused && nNew == 0);
%! % a run that was lost starts from the stage that is there
%! unlink (fullfile (r(1).folder, 'record.json'));
%! unlink (fullfile (r(1).folder, 'end.mark'));
%! again = runJobs (jobs(1), Case, quiet);
%! assert (~strcmp (again.folder, r(1).folder));
%! assert (numel (listRunFolders (Case.store, 'Fill')), 4);
%!test
%! % a stage that is a model of the case, too: one run is both
%! Case = readyCase ();
%! put = @(name, text) writeAtomic (fullfile (Case.models(2).folder, name), text);
%! put ('startsFrom', "First # its last state\n");
%! put ('runscript', [fileread(fullfile (Case.models(2).folder, 'runscript')), ...
%!                    "paste First/out out > both\n"]);
%! jobs = newJobs (Case, [1, 2; 3, 4], [], 1, 'plan');
%! [r, ~, nNew] = runJobs (jobs, Case, quiet);
%! assert ({r.status}, repmat ({'ok'}, 1, 4));
%! assert (nNew, 4);
%! assert (numel (listRunFolders (Case.store, 'First')), 2);
%! assert (canonicalize_file_name (fullfile (r(4).folder, 'First')), ...
%!         canonicalize_file_name (r(3).folder));

% SPDX-License-Identifier: GPL-3.0-only
