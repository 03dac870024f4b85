% RUNPLAN  Runs the plan on all models and keeps the responses as CSV.
%
% CALL: DATA = runPlan (PLAN, DATA, CASE, EVALUATE, SAY)
%
%   PLAN      n x d; may have no rows
%   DATA      see newData: what is known already, and with the plan's rows
%   CASE      see newCase
%   EVALUATE  see newEvaluate
%   SAY       function handle that takes one line of text
%
% Rows that have no result for some model are left out of the files
% ExperimentalPlan_DoE.csv and results/DoE_<model>_<i>/DoE_<model>_<i>.csv, as
% published; DATA keeps them with NaN. Rows that Input.maxNewRuns does not allow
% are left out of DATA.
%
% Errors: DEcalioc:runPlan:tooManyFailures, with a table of what failed;
% DEcalioc:runPlan:tooFewRuns where Input.maxNewRuns leaves too few
%
% See also: GenerateExperPlan, fitSurrogates

function data = runPlan (plan, data, Case, evaluate, say)
  isTried = true (rows (plan), 1);
  if rows (plan) > 0
    reportPlan (plan, Case, say);
    [Z, isTried] = evaluate (plan, 1, 'plan');
    data = addRows (data, plan(isTried, :), Z(isTried, :), ...
                    ones (sum (isTried), 1), 'plan');
  end
  isWhole = all (isfinite (data.Z), 2);
  checkBudget (sum (isWhole), isTried, Case);
  checkFailures (isWhole(isWhole | isOwn (data)), Case);
  writeMatrix (fullfile (Case.folder, 'ExperimentalPlan_DoE.csv'), ...
               data.X(isWhole, :));
  for t = 1:numel (Case.targets)
    name = sprintf ('DoE_%s_%d', Case.targets(t).modelName, ...
                    Case.targets(t).index);
    folder = fullfile (Case.folder, 'results', name);
    [~, ~] = mkdir (folder);
    writeMatrix (fullfile (folder, [name, '.csv']), data.Z(isWhole, t));
  end
end

function checkBudget (nWhole, isTried, Case)
  least = fewestSets (Case);
  if nWhole < least && ~all (isTried)
    error ('DEcalioc:runPlan:tooFewRuns', ...
           ['runPlan: the surrogates need %d finished sets, got %d: ' ...
            'Input.maxNewRuns = %g left %d of the plan''s %d sets without ' ...
            'a run. Raise it and start again; finished runs are kept.'], ...
           least, nWhole, Case.options.maxNewRuns, sum (~isTried), ...
           numel (isTried));
  end
end

% Surrogates need more rows than parameters.
function n = fewestSets (Case)
  n = numel (Case.names) + 2;
end

% Where a third of the plan fails, the box or the model is at fault.
function checkFailures (isWhole, Case)
  n = numel (isWhole);
  if sum (isWhole) >= max (2 / 3 * n, fewestSets (Case))
    return
  end
  lines = {};
  for k = 1:numel (Case.models)
    lines = [lines, failuresOf(Case, Case.models(k).name)];
  end
  error ('DEcalioc:runPlan:tooManyFailures', ...
         ['runPlan: at least two thirds of the plan and %d runs must ' ...
          'succeed, got %d of %d. What failed:\n%s\nCorrect the model or ' ...
          'the limits and start again; finished runs are kept.'], ...
         fewestSets (Case), sum (isWhole), n, ...
         strjoin (unique (lines), "\n"));
end

function lines = failuresOf (Case, model)
  lines = {};
  names = listRunFolders (Case.store, model);
  for i = 1:numel (names)
    folder = fullfile (Case.store, 'optim', model, names{i});
    record = readRecord (fullfile (folder, 'record.json'));
    if ~isempty (record) && ~strcmp (record.status, 'ok')
      lines{end + 1} = sprintf ('  %s/%s  %-8s %s', model, names{i}, ...
                                record.status, record.message);
    end
  end
end

%!test
%! raw = standInCase (tempname ());
%! Case = newCase (raw);
%! evaluate = newEvaluate (Case, newLedger (), @(text) []);
%! data = runPlan ([1, 2; 3, 4; 5, 6; 7, 8], newData (2, 3), Case, ...
%!                 evaluate, @(text) []);
%! assert (data.Z(2, :), [7, 12, -1], 1e-12);
%! file = fullfile (raw.folder, 'results', 'DoE_First_2', 'DoE_First_2.csv');
%! assert (csvread (file), [2; 12; 30; 56], 1e-12);
%!test
%! Case = newCase (standInCase (tempname ()));
%! writeAtomic (fullfile (Case.models(1).folder, 'runscript'), ...
%!              "echo 'ERROR: no such box' ; exit 1\n");
%! evaluate = newEvaluate (Case, newLedger (), @(text) []);
%! try
%!   runPlan (magic (4)(:, 1:2), newData (2, 3), Case, evaluate, @(t) []);
%! catch err
%! end
%! assert (err.identifier, 'DEcalioc:runPlan:tooManyFailures');
%! assert (! isempty (strfind (err.message, 'no such box')));
%!test
%! % a budget below the plan: what was run is used, or too little is said
%! raw = standInCase (tempname ());
%! raw.Input.maxNewRuns = 8;
%! Case = newCase (raw);
%! evaluate = newEvaluate (Case, newLedger (), @(text) []);
%! data = runPlan (magic (6)(:, 1:2), newData (2, 3), Case, evaluate, @(t) []);
%! assert (rows (data.Z), 4);
%! Case.options.maxNewRuns = 2;
%! evaluate = newEvaluate (Case, newLedger (), @(text) []);
%! try
%!   runPlan (10 * magic (6)(:, 1:2), newData (2, 3), Case, evaluate, @(t) []);
%! catch err
%! end
%! assert (err.identifier, 'DEcalioc:runPlan:tooFewRuns');
%!test
%! % rows of runs.csv that have one model only are no failures
%! Case = newCase (standInCase (tempname ()));
%! evaluate = newEvaluate (Case, newLedger (), @(text) []);
%! data = addRows (newData (2, 3), rand (20, 2), [ones(20, 2), NaN(20, 1)], ...
%!                 ones (20, 1), 'import');
%! data = runPlan (magic (4)(:, 1:2), data, Case, evaluate, @(text) []);
%! assert (rows (data.Z), 24);
%! assert (isempty (failedSets (addRows (data, data.X(1, :), data.Z(1, :), ...
%!                                       2, 'import'))));
