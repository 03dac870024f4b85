% STAYATRUNS  A set that was run goes before a new one that is hardly surer.
%
% CALL: FOUND = stayAtRuns (STATE, PROBLEM)
%
% STATE  struct of newState with its found set;  PROBLEM  see newProblem
% FOUND  that set; or the set of a row that counts, whose rows meet the targets
%        and which is sure enough (options.confidence) or hardly less likely than
%        the found one (options.better), never below options.even; of several the
%        likeliest. Where runs can be made, only of own runs beside another source
%        (others of STATE)
%
% The set of another source that trustLibrary has run need not be confirmed at
% another place beside. And who runs the set by himself and adds it to runs.csv
% moves the surrogates, and with them the surest set, a little each time: without
% this the set that is to be run next would never be one that was run.

function found = stayAtRuns (state, problem)
  found = state.found;
  data = runsThatCount (state.data, problem);
  if budgetLeft (state, problem) > 0
    if isempty (state.others)
      return
    end
    data = keepRows (data, ~ismember (data.stage, {'import', 'library'}));
  end
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
%! % where runs can be made only at those of this case; not where its rows miss
%! s.budget.left = Inf;
%! assert (stayAtRuns (s, problem), s.found);
%! s.data.stage(end) = {'plan'};
%! assert (stayAtRuns (s, problem), s.found);
%! s.others = struct ('source', 'import');
%! assert (stayAtRuns (s, problem).params, near, 1e-12);
%! s.budget.left = 0;
%! s.data.Z(end, :) = 2 * s.data.Z(end, :);
%! assert (stayAtRuns (s, problem), s.found);

% SPDX-License-Identifier: GPL-3.0-only
