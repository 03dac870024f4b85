% LEVELSECONDS  What a run costs at each level, as the runs so far tell.
%
% CALL: SECONDS = levelSeconds (STATE, PROBLEM)
%
%   STATE    see newState; budget.levels is read
%   PROBLEM  see newProblem
%   SECONDS  1 x L, mean of each level; where a level has no run yet, along the
%            straight line of its logarithm through the others; [] where no
%            level has a run

function seconds = levelSeconds (state, problem)
  seconds = [];
  costs = state.budget.levels;
  if isempty (problem.coarse) || isempty (costs)
    return
  end
  levels = problem.coarse.levels;
  [L, v] = size (levels);
  seconds = NaN (1, L);
  for k = 1:L
    seconds(k) = mean (costs(all (costs(:, 1:v) == levels(k, :), 2), end));
  end
  known = find (isfinite (seconds));
  law = polyfit (known, log (seconds(known)), min (1, numel (known) - 1));
  lost = setdiff (1:L, known);
  seconds(lost) = exp (polyval (law, lost));
end

%!function seconds = of (costs)
%!  state.budget.levels = costs;
%!  problem.coarse.levels = [3; 2; 1];
%!  seconds = levelSeconds (state, problem);
%!endfunction
%!assert (of ([]), []);
%!assert (of ([3, 1; 3, 3; 1, 18]), [2, 6, 18], 1e-9);
%!assert (of ([2, 5]), [5, 5, 5], 1e-9);
