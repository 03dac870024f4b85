% BUDGETLEFT  DEM runs that may still be made after the plan.
%
% CALL: N = budgetLeft (STATE, PROBLEM)
%
% STATE    struct of newState; PROBLEM  struct of newProblem
% N        scalar: options.maxFunEvals less what was spent (failed rows count),
%          and no more than PROBLEM.newSets () says can be made in this start
%
% See also: runRows, withinBudget

function n = budgetLeft (state, problem)
  n = problem.options.maxFunEvals - state.spent.infill - state.spent.verify;
  n = max (0, floor (min (n, problem.newSets ())));
end
