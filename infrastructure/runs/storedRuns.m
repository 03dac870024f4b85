% STOREDRUNS  All that the store knows of the runs of a case.
%
% CALL: RUNS = storedRuns (CASE)
%
%   CASE  see newCase
%   RUNS  1 x n struct array in the order of their starts, see pageData; [] none
%
% In a store that other cases share, only the own runs inside the limits count.

function runs = storedRuns (Case)
  runs = [];
  slack = 1e-9 * diff (Case.limits(1:2, :));
  if ~sharesStore (Case)
    slack = Inf;
  end
  if ~all (cellfun (@isfolder, {Case.models.folder}))
    return
  end
  h = hashModels (Case);
  for k = 1:numel (Case.models)
    model = Case.models(k).name;
    for name = runFoldersOf (Case, model)(:)'
      run = oneRun (runPlace (Case, model, name{1}), name{1}, h(k), Case.names);
      if ~isempty (run) && numel (run.params) == numel (Case.names) && ...
         all (run.params >= Case.limits(1, :) - slack & ...
              run.params <= Case.limits(2, :) + slack)
        runs = [runs, run];
      end
    end
  end
  if ~isempty (runs)
    [~, order] = sort ([runs.started]);
    runs = runs(order);
  end
end

function run = oneRun (folder, name, h, names)
  run = [];
  record = readingOf (readSane (fullfile (folder, 'record.json')), h);
  if isempty (record)
    record = readSane (fullfile (folder, 'job.json'));
  end
  if isempty (record)
    return
  end
  record = inOrderOf (record, names);
  run = struct ('model', '', 'name', '', 'stage', '', 'params', [], ...
                'effects', [], 'replicate', 1, 'seed', NaN, ...
                'status', 'not ended', 'cause', '', 'message', '', ...
                'results', [], 'seconds', NaN, 'started', NaN);
  for field = fieldnames (run)'
    if ~isempty (jsonAt (record, field))
      run.(field{1}) = record.(field{1});
    end
  end
  if strcmp (run.status, 'ended')
    run.status = 'ok';
    run.message = 'to be read anew: OctaveFuns or measured.csv have changed';
  end
  run.name = name;
  run.params = run.params(:)';
  % the end mark is written at the end; a run without one began with its job
  mark = stat (fullfile (folder, 'end.mark'));
  job = stat (fullfile (folder, 'job.json'));
  if ~isempty (mark) && isfinite (run.seconds)
    run.started = mark.mtime - run.seconds;
  elseif ~isempty (job)
    run.started = job.mtime;
  end
end

%!test
%! Case = readyCase ();
%! assert (isempty (storedRuns (Case)));
%! evaluateDEM ([1, 2], Case);
%! runs = storedRuns (Case);
%! assert ({runs.status}, {'ok', 'ok'});
%! assert (runs(1).params, [1, 2]);
%! Case.names = {'b', 'a'};
%! assert (storedRuns (Case)(1).params, [2, 1]);

% SPDX-License-Identifier: GPL-3.0-only
