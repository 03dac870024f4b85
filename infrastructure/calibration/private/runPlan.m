% RUNPLAN  Runs the plan on all models and keeps the responses as CSV.
%
% CALL: STATE = runPlan (STATE, PROBLEM, PLAN, E, CASE, SAY)
%
%   STATE    see newState: its data is what is known already
%   PLAN, E  n x d, n x v, rows and their levels, see newPlan; n may be 0
%
% Rows that have no result for some model are left out of the files
% ExperimentalPlan_DoE.csv and results/DoE_<model>_<i>/DoE_<model>_<i>.csv, as
% published (with levels these are further columns of the first one); the data
% keep them with NaN. Rows that Input.maxNewRuns does not allow are left out of
% it.
%
% Errors: DEcalioc:runPlan:lacksResult where hardly a run has a result that it lacks beside
% others; DEcalioc:runPlan:tooManyFailures, with a table of what failed;
% DEcalioc:runPlan:tooFewRuns where Input.maxNewRuns, or a runs.csv without
% models to run, leaves too few

function state = runPlan (state, problem, plan, E, Case, say)
  before = rows (state.data.X);
  if rows (plan) > 0
    sayPlan (plan, Case, say, E);
    state = addRuns (state, problem, plan, E, 'plan');
  end
  data = state.data;
  isWhole = all (isfinite (data.Z), 2);
  refuseLacking (data, problem);
  isRun = ~lostRows (data.Z, problem.bench) & any (isfinite (data.Z), 2);
  checkEnough (data, isRun, before + rows (plan) - rows (data.X), Case, ...
               problem.options.planShare);
  writeMatrix (fullfile (Case.folder, 'ExperimentalPlan_DoE.csv'), ...
               [data.X(isWhole, :), data.E(isWhole, :)]);
  for t = 1:numel (Case.targets)
    name = sprintf ('DoE_%s_%d', Case.targets(t).modelName, ...
                    Case.targets(t).index);
    folder = fullfile (Case.folder, 'results', name);
    [~, ~] = mkdir (folder);
    writeMatrix (fullfile (folder, [name, '.csv']), data.Z(isWhole, t));
  end
end

% Runs that end well and have their other results: more of them have not this one either.
function refuseLacking (data, problem)
  least = columns (data.X) + 1;
  isOurs = ~ismember (data.stage, {'import', 'library'});
  [lacking, hasAny] = lackingRows (data.Z, problem.bench);
  for t = find (problem.calibrate)
    isRun = hasAny(:, t) & isOurs;
    lacks = lacking(:, t) & isOurs;
    have = rows (unique (data.X(isfinite (data.Z(:, t)), :), 'rows'));
    if have < least && sum (lacks) >= max (2, 0.5 * sum (isRun))
      error ('DEcalioc:runPlan:lacksResult', ...
             ['runPlan: %s must be a number in the runs of at least %d sets, got %d; %d of ' ...
              '%d runs lack it, and have the other results of %s. If nothing flows or ' ...
              'happens there, that is an outcome and no fault: let getResults return 0 ' ...
              'for it, not NaN. Else see what getResults reads for it.'], ...
             problem.targetNames{t}, least, have, sum (lacks), sum (isRun), ...
             problem.benchNames{problem.bench(t)});
    end
  end
end

% Surrogates need more sets than parameters; where a third of the plan fails,
% the box or the model is at fault.
function checkEnough (data, isRun, nLeftOut, Case, share)
  have = finishedSets (data);
  least = numel (Case.names) + 1;
  isOurs = ~ismember (data.stage, {'import', 'library'});
  n = sum (isOurs | isRun);
  if have < least && nLeftOut > 0
    error ('DEcalioc:runPlan:tooFewRuns', ...
           ['runPlan: the surrogates need %d finished sets, got %d: ' ...
            'Input.maxNewRuns = %g left %d of the plan''s sets without ' ...
            'a run. Raise it and start again; finished runs are kept.'], ...
           least, have, Case.options.maxNewRuns, nLeftOut);
  elseif have < least && all (isRun(isOurs))
    error ('DEcalioc:runPlan:tooFewRuns', ...
           ['runPlan: the surrogates need %d different sets with a ' ...
            'result for every target, got %d. Give more rows in runs.csv, ' ...
            'or raise %s.'], least, have, ...
           merge (Case.options.maxNewRuns == 0, 'Input.maxNewRuns', 'Input.numOfSam'));
  elseif have < least || sum (isRun) < share * n
    lines = failuresOf (Case);
    error ('DEcalioc:runPlan:tooManyFailures', ...
           ['runPlan: at least two thirds of the plan and %d sets must ' ...
            'succeed, got %d of %d. What failed:\n%s\nCorrect the model or ' ...
            'the limits and start again; finished runs are kept.'], ...
           least, sum (isRun), n, strjoin (unique (lines), "\n"));
  end
end

function lines = failuresOf (Case)
  lines = {};
  for run = storedRuns (Case)
    if ~any (strcmp (run.status, {'ok', 'not ended'}))
      lines{end + 1} = sprintf ('  %s/%s  %-8s %s', run.model, run.name, ...
                                run.status, run.message);
    end
  end
end

function sayPlan (plan, Case, say, E)
  say (['Experimental plan: ', countText(rows (plan), 'sample')]);
  names = [Case.names, Case.effectVars(1:columns (E))];
  width = max (cellfun (@numel, names), 9);
  head = [num2cell(width); names];
  say (['   run', sprintf('  %*s', head{:})]);
  for i = 1:rows (plan)
    say (sprintf ('  %4d%s', i, sprintf ('  %*.5g', [width; plan(i, :), ...
                                                     E(i, :)])));
  end
end

%!function [state, message] = ran (Case, plan, data)
%!  state = newState (data);
%!  [state.evaluate, state.budget] = newCaseEvaluate (Case, @(text) []);
%!  message = '';
%!  try
%!    state = runPlan (state, newProblem (Case), plan, ...
%!                     zeros (rows (plan), 0), Case, @(text) []);
%!  catch err
%!    message = [err.identifier, ' ', err.message];
%!  end
%!endfunction

%!test
%! % the table of results; then rows of runs.csv that have one model only: no
%! % failures
%! Case = readyCase ();
%! data = ran (Case, [1, 2; 3, 4; 5, 6; 7, 8], newData (2, 3)).data;
%! assert (data.Z(2, :), [7, 12, -1], 1e-12);
%! file = fullfile (Case.folder, 'results', 'DoE_First_2', 'DoE_First_2.csv');
%! assert (csvread (file), [2; 12; 30; 56], 1e-12);
%! data = addRows (newData (2, 3), rand (20, 2), [ones(20, 2), NaN(20, 1)], ...
%!                 ones (20, 1), 'import');
%! data = ran (Case, magic (4)(:, 1:2), data).data;
%! assert (rows (data.Z), 24);
%! data = addRows (data, data.X(1, :), data.Z(1, :), 2, 'import');
%! assert (isempty (failedSets (data, struct ('fine', zeros (1, 0)))));

%!test
%! Case = readyCase ();
%! writeAtomic (fullfile (Case.models(1).folder, 'runscript'), ...
%!              "echo 'ERROR: no such box' ; exit 1\n");
%! [~, message] = ran (Case, magic (4)(:, 1:2), newData (2, 3));
%! assert (strncmp (message, 'DEcalioc:runPlan:tooManyFailures ', 33));
%! assert (~isempty (strfind (message, 'no such box')));

%!test
%! % a budget below the plan: what was run is used, or too little is said
%! Case = readyCase ();
%! Case.options.maxNewRuns = 8;
%! state = ran (Case, magic (6)(:, 1:2), newData (2, 3));
%! assert ([rows(state.data.Z), state.budget.left], [4, 0]);
%! Case.options.maxNewRuns = 2;
%! [~, message] = ran (Case, 10 * magic (6)(:, 1:2), newData (2, 3));
%! assert (strncmp (message, 'DEcalioc:runPlan:tooFewRuns ', 28));
%! % runs.csv alone, two models at different sets; then too few of them
%! Case.options.maxNewRuns = 0;
%! Z = [ones(5, 2), NaN(5, 1); NaN(5, 2), ones(5, 1)];
%! data = addRows (newData (2, 3), 10 * rand (10, 2), Z, ones (10, 1), ...
%!                 'import');
%! none = zeros (0, 2);
%! assert (rows (ran (Case, none, data).data.Z), 10);
%! data.X(6:10, :) = repmat (data.X(6, :), 5, 1);
%! [~, message] = ran (Case, none, data);
%! assert (regexp (message, '^DEcalioc:runPlan:tooFewRuns .*got 1\.'), 1);

% SPDX-License-Identifier: GPL-3.0-only
