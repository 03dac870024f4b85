% BUDGETLEFT  DEM runs that may still be made after the plan.
%
% CALL: n = budgetLeft (state, problem)
%
% state    struct of newState; problem  struct of newProblem
% n        scalar: the lesser of options.maxFunEvals and options.maxNewRuns,
%          less what was spent (failed rows count)
%
% See also: runRows

function n = budgetLeft (state, problem)
  n = min (problem.options.maxFunEvals, problem.options.maxNewRuns) - ...
      state.spent.infill - state.spent.verify;
  n = max (0, floor (n));
end
