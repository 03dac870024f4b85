% PAGERUNS  All runs of a case that its store knows, finished or not.
%
% CALL: RUNS = pageRuns (CASE)
%
%   CASE  see newCase
%   RUNS  1 x n struct array in the order of their starts: model, name (of the
%         folder), stage, planRow, params (1 x d), effects, replicate, seed,
%         status ('ok', 'failed', 'timeout', 'invalid', 'not ended'), cause,
%         message, results, seconds, started (s since 1970; NaN: unknown), key
%
% Nothing is run, evaluated or changed. In a store that other cases share, only
% their own runs inside the limits count.

function runs = pageRuns (Case)
  runs = blank ();
  runs(1) = [];
  for k = 1:numel (Case.models)
    model = Case.models(k).name;
    names = runFoldersOf (Case, model, []);
    for i = 1:numel (names)
      folder = fullfile (Case.store, 'optim', model, names{i});
      run = oneRun (folder, names{i});
      if ~isempty (run) && isOfCase (run, Case)
        runs(end + 1) = run;
      end
    end
  end
  if ~isempty (runs)
    [~, order] = sort ([runs.started]);
    runs = runs(order);
  end
end

function run = blank ()
  run = struct ('model', '', 'name', '', 'stage', '', 'planRow', 0, ...
                'params', [], 'effects', [], 'replicate', 1, 'seed', NaN, ...
                'status', 'not ended', 'cause', '', 'message', '', ...
                'results', [], 'seconds', NaN, 'started', NaN, 'key', '');
end

function run = oneRun (folder, name)
  run = [];
  record = readRecord (fullfile (folder, 'record.json'));
  if isempty (record)
    record = readRecord (fullfile (folder, 'job.json'));
  end
  if isempty (record)
    return
  end
  run = blank ();
  run.name = name;
  for field = fieldnames (run)'
    if isfield (record, field{1}) && ~isempty (record.(field{1}))
      run.(field{1}) = record.(field{1});
    end
  end
  run.params = reshape (run.params, 1, []);
  run.started = startOf (folder, run.seconds);
end

% The end mark is written at the end; a run without one began with its job.
function seconds = startOf (folder, lasted)
  mark = stat (fullfile (folder, 'end.mark'));
  job = stat (fullfile (folder, 'job.json'));
  seconds = NaN;
  if ~isempty (mark) && isfinite (lasted)
    seconds = mark.mtime - lasted;
  elseif ~isempty (job)
    seconds = job.mtime;
  end
end

function yes = isOfCase (run, Case)
  yes = numel (run.params) == numel (Case.names);
  if yes && ~strcmp (Case.store, Case.folder)
    slack = 1e-9 * diff (Case.limits);
    yes = all (run.params >= Case.limits(1, :) - slack & ...
               run.params <= Case.limits(2, :) + slack);
  end
end

%!test
%! raw = standInCase (tempname ());
%! writeAtomic (fullfile (raw.folder, 'DEMmodels', 'Second', 'runscript'), ...
%!              "exit 3\n");
%! Case = newCase (raw);
%! evaluateDEM ([1, 2; 3, 4], Case);
%! prepareRun (newJobs (Case, [5, 6], [], 1, 'plan')(1), Case);
%! runs = pageRuns (Case);
%! % what fails is tried once more, with another seed
%! assert (numel (runs), 7);
%! assert (sum (strcmp ({runs.status}, 'ok')), 2);
%! assert (sum (strcmp ({runs.status}, 'failed')), 4);
%! assert (sum (strcmp ({runs.status}, 'not ended')), 1);
%! assert (all (diff ([runs.started]) >= 0));
%! assert (sum (arrayfun (@(r) isequal (r.params, [3, 4]), runs)), 3);
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (Case.folder, 's');
