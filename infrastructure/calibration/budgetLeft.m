% BUDGETLEFT  Sets that may still be run after the plan, and what limits them.
%
% CALL: [N, LIMIT] = budgetLeft (STATE, PROBLEM)
%
% STATE    struct of newState; PROBLEM  struct of newProblem
% N        scalar: options.maxFunEvals less the rows after the plan (failed ones
%          count), and no more than this start can make. A run at a coarser
%          level counts as what it costs
% LIMIT    'maxNewRuns' where this start can make no more, else 'maxFunEvals'

function [n, limit] = budgetLeft (state, problem)
  isLater = isAfterPlan (state.data);
  n = problem.options.maxFunEvals - sum (isLater);
  seconds = levelSeconds (state, problem);
  if ~isempty (seconds)
    [~, level] = ismember (state.data.E(isLater, :), problem.coarse.levels, ...
                           'rows');
    n = n + sum (1 - min (1, seconds(level) / seconds(end)));
  end
  sets = setsLeft (state.budget);
  limit = 'maxFunEvals';
  if sets < 1
    limit = 'maxNewRuns';
  end
  n = max (0, floor (min (n, sets)));
end

% Sets that may still be run in this start: runs in the store cost nothing, so
% where no run is left it is Inf until a set was wanted that is not in there.
function n = setsLeft (budget)
  n = floor (budget.left / budget.perSet);
  if n < 1
    n = merge (budget.isUsedUp, 0, Inf);
  end
end

%!test
%! state = newState (addRows (newData (1, 1), [1; 2], [1; 2], [1; 1], ...
%!                           'verify'));
%! problem = struct ('coarse', [], 'options', struct ('maxFunEvals', 9));
%! left = @(perSet, left, isUsedUp) budgetLeft (setfield (state, 'budget', ...
%!   struct ('perSet', perSet, 'left', left, 'isUsedUp', isUsedUp, ...
%!           'levels', [])), problem);
%! assert ([left(1, Inf, false), left(2, 7, false), left(2, 1, false), ...
%!          left(2, 1, true)], [7, 3, 7, 0]);
