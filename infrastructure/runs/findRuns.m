% FINDRUNS  Finds the runs of a list of jobs that are in the store already.
%
% CALL: RECORDS = findRuns (JOBS, CASE)
%
%   JOBS     1 x n struct array, see newJobs
%   CASE     see newCase
%   RECORDS  1 x n cell: the record of the run with the job's key, or a struct
%            with the field folder alone where its simulation has ended but
%            was not evaluated, or [] where it must be run
%
% Of several runs with one key the first of these: ok, ended without a valid
% result, ended but not evaluated, failed.

function records = findRuns (jobs, Case)
  records = cell (1, numel (jobs));
  h = [];
  for model = unique ({jobs.model})
    mine = find (strcmp ({jobs.model}, model{1}));
    isShared = ~strcmp (Case.store, Case.folder);
    if isempty (h) && isShared
      h = hashModels (Case);
    end
    own = strcmp (model{1}, {Case.models.name});
    names = runFoldersOf (Case, model{1}, h(own & isShared), jobs(mine));
    found = scan (fullfile (Case.store, 'optim', model{1}), names);
    if isempty (found.keys)
      continue
    end
    if isempty (h) && ~all (ismember ({jobs(mine).key}, found.keys))
      h = hashModels (Case);
    end
    for i = mine
      keys = {jobs(i).key, olderKey(jobs(i), Case, h, found.keys)};
      hits = find (ismember (found.keys, keys));
      if ~isempty (hits)
        [~, best] = max (found.worth(hits));
        records{i} = found.records{hits(best)};
      end
    end
  end
end

% Key that earlier versions gave to a job that is not among those KNOWN.
function key = olderKey (job, Case, h, known)
  key = 'none';
  if ~ismember (job.key, known)
    isOfModel = strcmp (job.model, {Case.models.name});
    [~, older] = runKey (runVariables (job, Case), Case.effectVars, ...
                         h(isOfModel));
    if ~isempty (older)
      key = older;
    end
  end
end

function found = scan (place, names)
  n = numel (names);
  found = struct ('keys', {cell(1, n)}, 'records', {cell(1, n)}, ...
                  'worth', zeros (1, n));
  for i = 1:n
    folder = fullfile (place, names{i});
    record = readRecord (fullfile (folder, 'record.json'));
    if isempty (record)
      [record, found.keys{i}] = unevaluated (folder);
      found.worth(i) = 2 * ~isempty (record);
    else
      record.folder = folder;
      found.keys{i} = record.key;
      found.worth(i) = 1 + 3 * strcmp (record.status, 'ok') + ...
                       2 * strcmp (record.status, 'invalid');
    end
    found.records{i} = record;
  end
end

function [record, key] = unevaluated (folder)
  record = [];
  key = '';
  job = unevaluatedJob (folder);
  if ~isempty (job)
    key = job.key;
    record = struct ('folder', folder);
  end
end

%!test
%! % a run that was found under the build, though its model does not call it
%! Case = newCase (standInCase (tempname ()));
%! before = getenv ('PATH');
%! restore = onCleanup (@() setenv ('PATH', before));
%! bin = tempname ();
%! mkdir (bin);
%! writeAtomic (fullfile (bin, 'liggghts'), 'a build');
%! system (['chmod +x ', fullfile(bin, 'liggghts')]);
%! setenv ('PATH', [bin, ':', before]);
%! job = newJobs (Case, [1, 2], [], 1, 'plan')(2);
%! h = hashModels (Case)(2);
%! old = job;
%! [key, old.key] = runKey (runVariables (job, Case), {}, h);
%! assert (key, job.key);
%! failedRecord (old, prepareRun (old, Case), 'invalid', 'x', 'output');
%! assert (findRuns (job, Case){1}.key, old.key);
%! assert ([runsOfCase(Case).isCurrent], true);
%! % cron has no HOME, and the build is not found: the same runs all the same
%! setenv ('PATH', before);
%! assert (strcmp (newJobs (Case, [1, 2], [], 1, 'plan')(2).key, job.key));
%!test
%! % a simulation that ended but was not evaluated goes before one that failed
%! Case = newCase (standInCase (tempname ()));
%! job = newJobs (Case, [1, 2], [], 1, 'plan')(2);
%! for status = {'timeout', ''}
%!   folder = prepareRun (job, Case);
%!   if isempty (status{1})
%!     writeAtomic (fullfile (folder, 'end.mark'), "0 1.0 finished\n");
%!   else
%!     failedRecord (job, folder, status{1}, 'too slow', 'time');
%!   end
%! end
%! assert (findRuns (job, Case){1}, struct ('folder', folder));
