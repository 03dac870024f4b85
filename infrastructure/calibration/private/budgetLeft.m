% BUDGETLEFT  Sets that may still be run after the plan, and what limits them.
%
% CALL: [N, LIMIT, SECONDS] = budgetLeft (STATE, PROBLEM)
%
% STATE    struct of newState; PROBLEM  struct of newProblem
% N        scalar: options.maxFunEvals less the rows after the plan (failed ones
%          count), and no more than this start can make. A run at a coarser
%          level counts as what it costs
% LIMIT    'maxNewRuns' where this start can make no more, else 'maxFunEvals'
% SECONDS  1 x L, what a run costs at each level: the mean of its runs; where it
%          has none yet, along the straight line of the logarithm through the
%          others; [] where no level has a run

function [n, limit, seconds] = budgetLeft (state, problem)
  isLater = isAfterPlan (state.data);
  n = problem.options.maxFunEvals - sum (isLater);
  seconds = levelSeconds (state.budget.levels, problem.coarse);
  if ~isempty (seconds)
    [~, level] = ismember (state.data.E(isLater, :), problem.coarse.levels, ...
                           'rows');
    n = n + sum (1 - min (1, seconds(level) / seconds(end)));
  end
  sets = floor (state.budget.left / sum (state.budget.models));
  limit = 'maxFunEvals';
  if sets < 1 && state.budget.isUsedUp
    limit = 'maxNewRuns';
  elseif sets < 1
    sets = Inf;   % runs of the store cost nothing: until one is not in there
  end
  n = max (0, floor (min (n, sets)));
end

function seconds = levelSeconds (costs, coarse)
  seconds = [];
  if isempty (coarse) || isempty (costs)
    return
  end
  [L, v] = size (coarse.levels);
  for k = 1:L
    isAtLevel = all (costs(:, 1:v) == coarse.levels(k, :), 2);
    seconds(k) = mean (costs(isAtLevel, end));
  end
  known = find (isfinite (seconds));
  law = polyfit (known, log (seconds(known)), min (1, numel (known) - 1));
  lost = setdiff (1:L, known);
  seconds(lost) = exp (polyval (law, lost));
end

%!test
%! state = newState (addRows (newData (1, 1), [1; 2], [1; 2], [1; 1], ...
%!                           'verify'));
%! problem = struct ('coarse', [], 'options', struct ('maxFunEvals', 9));
%! left = @(M, left, isUsedUp) budgetLeft (setfield (state, 'budget', ...
%!   struct ('models', true (1, M), 'left', left, 'isUsedUp', isUsedUp, ...
%!           'levels', [])), problem);
%! assert ([left(1, Inf, false), left(2, 7, false), left(2, 1, false), ...
%!          left(2, 1, true)], [7, 3, 7, 0]);
%!function seconds = of (costs)
%!  state = newState (newData (1, 1, 1));
%!  state.budget.levels = costs;
%!  problem.options.maxFunEvals = 9;
%!  problem.coarse.levels = [3; 2; 1];
%!  [~, ~, seconds] = budgetLeft (state, problem);
%!endfunction
%!assert (of ([]), []);
%!assert (of ([3, 1; 3, 3; 1, 18]), [2, 6, 18], 1e-9);
%!assert (of ([2, 5]), [5, 5, 5], 1e-9);

% SPDX-License-Identifier: GPL-3.0-only
