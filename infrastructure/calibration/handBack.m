% HANDBACK  Hands back the best set that was run, not one that never was.
%
% CALL: STATE = handBack (STATE, PROBLEM)
%
% STATE    struct of newState with final; where that is not confirmed, the set
%          that this case has run and that is likeliest to meet the targets
%          takes its place in found and final (among sets without a chance the
%          one that misses least). final.untested: 1 x d, the set that the
%          surrogates had proposed instead, never run; 0 x d: none. Where
%          nothing was run but imported rows, the set of the surrogates stays.
%          found.conflict is looked up once more: it decides what is said
% PROBLEM  struct of newProblem
%
% The surrogates hold all runs, so a lucky single run does not win.

function state = handBack (state, problem)
  proposed = state.found.params;
  state.final.untested = zeros (0, numel (proposed));
  if state.final.converged
    return
  end
  X = setsThatRan (state, problem);
  if ~isempty (X)
    p = bestOf (X, proposed, state, problem);
    here = describeSet (state.surrogates, problem, p);
    conflict = state.found.conflict;
    state.found = mergeFields (state.found, here);
    state.found.conflict = conflict;
  end
  if isempty (state.found.conflict) && ~state.found.within
    state.found.conflict = findConflict (state.surrogates, problem);
  end
  isTried = any (sameSet ([state.data.X; state.found.params], proposed, ...
                          problem.limits));
  state.final = confirmSet (state, problem);
  state.final.untested = proposed(1:1 - isTried, :);
end

function X = setsThatRan (state, problem)
  data = runsThatCount (state.data, problem);
  isOurs = ~strcmp (data.stage, 'import') & all (isfinite (data.Z), 2);
  X = insideLimits (unique (data.X(isOurs, :), 'rows'), problem.limits);
end

% The set in hand stays where another one is hardly better.
function p = bestOf (X, p, state, problem)
  chance = meetProbability (state.surrogates, problem, X);
  r = targetResidual (problem, X, predictSurrogate (state.surrogates, X));
  worst = max (toleranceShare (problem, r), [], 2);
  better = problem.options.better;
  [~, order] = sortrows ([-round(chance / better), worst]);
  best = order(1);
  here = find (sameSet (X, p, problem.limits), 1);
  if isempty (here) || chance(here) < chance(best) - better || ...
     (chance(best) < better && worst(here) > 1.05 * worst(best))
    p = X(best, :);
  end
end

%!test
%! % three good runs are not given up for a set that was never run; what was
%! % imported is no run of this case
%! [problem, state, s] = smallCalibration ();
%! problem.options.replicates = 4;
%! good = [0.5, 1];
%! f = @(P) [3 + P(:, 1) + P(:, 2) / 2, 1 + P(:, 1) + P(:, 2) / 2.5];
%! problem.value = f (good);
%! % equal runs would count once
%! state.evaluate = newEvaluate (@(P, E, r) f (P) + 1e-3 * [r, -r]);
%! state = runAndFit (state, problem, repmat (good, 3, 1), 'verify');
%! state.found = describeSet (state.surrogates, problem, [0.52, 0.96]);
%! state.found.conflict = {};
%! state.final = confirmSet (state, problem);
%! out = handBack (state, problem);
%! assert (out.final.params, good);
%! assert (out.final.n, 3);
%! assert (out.final.untested, [0.52, 0.96]);
%! assert (isempty (out.found.conflict));
%! state.data.stage(:) = {'import'};
%! out = handBack (state, problem);
%! assert (out.final.params, [0.52, 0.96]);
%! assert (isempty (out.final.untested));
%!test
%! % out of reach: the conflict is found again, the nearest run handed back
%! [problem, state] = smallCalibration ();
%! problem.value = [4, 9];
%! state.found.conflict = {};
%! state.found = mergeFields (state.found, describeSet (state.surrogates, ...
%!                                                      problem, [1, 2]));
%! state.final = confirmSet (state, problem);
%! out = handBack (state, problem);
%! assert (out.final.n, 1);
%! assert (out.final.reason, 'no set of the box meets: y');
