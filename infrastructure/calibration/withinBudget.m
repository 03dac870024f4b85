% WITHINBUDGET  Lets a problem know what runs cost and how many may be made.
%
% CALL: PROBLEM = withinBudget (PROBLEM, LEDGER, CASE)
%
%   PROBLEM  see newProblem; its newSets then gives the number of parameter
%            sets, runs taken from the store not counted: where none may be run
%            anew it is Inf until a set was wanted that is not in the store; its
%            levelSeconds the core-seconds of a set at each level
%            (levelSeconds)
%   LEDGER   see newLedger
%   CASE     see newCase; Input.maxNewRuns counts runs, one a model and set;
%            where a model folder is not there, none can be made
%
% See also: budgetLeft, calibrateOnDEM

function problem = withinBudget (problem, ledger, Case)
  if ~isempty (problem.coarse)
    levels = problem.coarse.levels;
    problem.levelSeconds = @() levelSeconds (ledger('levels'), levels);
  end
  problem.newSets = @() setsLeft (ledger, Case);
end

function n = setsLeft (ledger, Case)
  n = floor ((Case.options.maxNewRuns - ledger('new')) / numel (Case.models));
  if any (cellfun (@isempty, {Case.models.folder}))
    n = 0;
  elseif n < 1
    n = merge (ledger('isUsedUp'), 0, Inf);
  end
end

%!test
%! ledger = newLedger ();
%! ledger('new') = 9;
%! Case = struct ('options', struct ('maxNewRuns', 16));
%! Case.models = struct ('folder', {'a', 'b'});
%! bare = struct ('coarse', []);
%! p = withinBudget (bare, ledger, Case);
%! assert (p.newSets (), 3);
%! ledger('new') = 16;
%! assert (p.newSets (), Inf);
%! ledger('isUsedUp') = true;
%! assert (p.newSets (), 0);
%! ledger('new') = 0;
%! Case.models(2).folder = '';
%! assert (withinBudget (bare, ledger, Case).newSets (), 0);
