% BUDGETLEFT  DEM runs that may still be made after the plan.
%
% CALL: N = budgetLeft (STATE, PROBLEM)
%
% STATE    struct of newState; PROBLEM  struct of newProblem
% N        scalar: options.maxFunEvals less what was spent (failed rows count),
%          and no more than PROBLEM.newSets () says can be made in this start. A
%          run at a coarser level counts as what it costs
%
% See also: runRows, withinBudget

function n = budgetLeft (state, problem)
  n = problem.options.maxFunEvals - state.spent.infill - state.spent.verify;
  seconds = problem.levelSeconds ();
  if ~isempty (problem.coarse) && ~isempty (seconds)
    later = ismember (state.data.stage, {'infill', 'verify', 'replicate'});
    [~, level] = ismember (state.data.E(later, :), problem.coarse.levels, ...
                           'rows');
    n = n + sum (1 - min (1, seconds(level) / seconds(end)));
  end
  n = max (0, floor (min (n, problem.newSets ())));
end
