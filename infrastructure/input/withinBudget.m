% WITHINBUDGET  Takes the runs made so far off the budget of a problem.
%
% CALL: PROBLEM = withinBudget (PROBLEM, LEDGER, CASE)
%
%   PROBLEM  see newProblem; its options.maxNewRuns counts parameter sets
%   LEDGER   see newLedger
%   CASE     see newCase; Input.maxNewRuns counts runs, one a model and set
%
% See also: calibrateOnDEM

function problem = withinBudget (problem, ledger, Case)
  left = Case.options.maxNewRuns - ledger('new');
  problem.options.maxNewRuns = max (0, floor (left / numel (Case.models)));
end

%!test
%! ledger = newLedger ();
%! ledger('new') = 9;
%! Case = struct ('options', struct ('maxNewRuns', 16), 'models', [1, 2]);
%! p = withinBudget (struct ('options', struct ()), ledger, Case);
%! assert (p.options.maxNewRuns, 3);
