% STAYATRUNS  Where no run can be made, a set that has runs goes before a new one.
%
% CALL: FOUND = stayAtRuns (STATE, PROBLEM)
%
% STATE  struct of newState with its found set;  PROBLEM  see newProblem
% FOUND  that set; or, where this start can make no run, the set of a row that
%        counts, whose rows meet the targets and which is sure enough
%        (options.confidence) or hardly less likely than the found one
%        (options.better), never below options.even; of several the likeliest
%
% Who runs the set by himself and adds it to runs.csv moves the surrogates, and
% with them the surest set, a little each time: without this the set that is to
% be run next would never be one that was run.

function found = stayAtRuns (state, problem)
  found = state.found;
  if budgetLeft (state, problem) > 0
    return
  end
  data = runsThatCount (state.data, problem);
  isWhole = all (isfinite (data.Z(:, problem.calibrate)), 2);
  inBox = all (data.X >= problem.limits(1, :) & ...
               data.X <= problem.limits(2, :), 2);
  X = unique (data.X(isWhole & inBox, :), 'rows');
  if isempty (X)
    return
  end
  [chance, share] = meetProbability (state.surrogates, problem, X);
  o = problem.options;
  least = max (o.even, min (o.confidence, found.probability - o.better));
  isGood = chance >= least & all (share <= 1, 2);
  [~, order] = sort (chance, 'descend');
  for k = order(isGood(order))'
    state.found = mergeFields (found, describeSet (state.surrogates, ...
                                                   problem, X(k, :)));
    state.found.conflict = {};
    final = confirmSet (state, problem);
    if final.within && final.probability >= least
      found = state.found;
      return
    end
  end
end

%!shared problem, state, law
%! [problem, state, ~, law] = smallCalibration ();
%! state.budget.left = 0;
%! state.budget.isUsedUp = true;
%! problem.value = [4, 1.9];
%!test
%! % no row is near: the new set; one beside it: that one
%! p = surestSet (state.surrogates, problem, state.found.params);
%! state.found = mergeFields (state.found, ...
%!                            describeSet (state.surrogates, problem, p));
%! problem.options.even = meetProbability (state.surrogates, problem, p) - 0.001;
%! assert (stayAtRuns (state, problem), state.found);
%! s = state;
%! near = p + 1e-5 * diff (problem.limits);
%! s.data = addRows (s.data, near, law (near), 1, 'import');
%! found = stayAtRuns (s, problem);
%! assert (found.params, near, 1e-12);
%! % not where runs can be made, nor where its rows miss
%! s.budget.left = Inf;
%! assert (stayAtRuns (s, problem), s.found);
%! s.budget.left = 0;
%! s.data.Z(end, :) = 2 * s.data.Z(end, :);
%! assert (stayAtRuns (s, problem), s.found);
