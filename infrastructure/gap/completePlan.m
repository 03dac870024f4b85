% COMPLETEPLAN  Runs the plan of a case where too few neutral runs are there.
%
% CALL: STATE = completePlan (STATE, PROBLEM, CASE, SAY)
%
%   STATE    see addRuns: data of gatherRuns
%   PROBLEM  see newProblem;  CASE  see newCase
%   SAY      function handle that takes one line of text
%
% A diagnosis wants 4 (d + 1) neutral sets, 40 at most, if it may run them, and
% mends its surrogates where that was not enough (diagnoseMatrices); without new
% runs it takes what is there. A bench all of whose runs gave no result, d + 3
% or more, is not waited for: enterRuns leaves it out.

function state = completePlan (state, problem, Case, say)
  data = state.data;
  d = numel (Case.names);
  phi = neutralEffects (Case)(numel (Case.coarse) + 1:end);
  isDead = ~any (isfinite (data.Z), 1) & ...
           sum (isnan (data.Z) & ~isna (data.Z), 1) >= d + 3;
  neutral = all (data.E == phi, 2) & all (isfinite (data.Z) | isDead, 2);
  have = rows (unique (data.X(neutral, :), 'rows'));
  wanted = max (Case.options.numOfSam, ...
                min (40, gapOptions ([]).neutral * (d + 1)));
  if isfield (data, 'level')
    atLast = neutral & ~any (data.level, 2);
    wanted = max (wanted, have + d + 3 - sum (atLast));
  end
  missing = min (wanted - have, ...
                 floor (state.budget.left / state.budget.perSet));
  if missing < 1
    return
  end
  say (sprintf ('plan: %d neutral sets there, %d more', have, missing));
  P = planBeside (data.X(neutral, :), missing, Case);
  n = rows (P);
  state = addRuns (state, problem, P, repmat (phi, n, 1), 'plan', ones (n, 1));
end

%!test
%! % sets there, sets missing, a bench that has never given a result
%! pkg load stk
%! Case = struct ('names', {{'a'}}, 'effects', [], 'coarse', [], ...
%!                'limits', [0; 1], 'folder', '');
%! Case.options = struct ('numOfSam', 12, 'seed', 1);
%! [state.evaluate, state.budget] = newEvaluate (@(P, E, r) [P, P]);
%! state.data = addRows (newData (1, 2), (1:12)' / 13, ...
%!                       [(1:12)', NaN(12, 1)], ...
%!                 ones (12, 1), 'plan');
%! assert (rows (completePlan (state, Case, Case, @(t) []).data.X), 12);
%! state.data.Z(:, 2) = NA;
%! assert (rows (completePlan (state, Case, Case, @(t) []).data.X), 24);
