% BUDGETLEFT  Sets that may still be run after the plan, and what limits them.
%
% CALL: [N, LIMIT] = budgetLeft (STATE, PROBLEM)
%
% STATE    struct of newState; PROBLEM  struct of newProblem
% N        scalar: options.maxFunEvals less the rows after the plan (failed ones
%          count), and no more than setsLeft of this start. A run at a coarser
%          level counts as what it costs
% LIMIT    'maxNewRuns' where this start can make no more, else 'maxFunEvals'
%
% See also: runAndFit, setsLeft

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
