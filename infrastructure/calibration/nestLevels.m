% NESTLEVELS  Runs the found set at the levels that have no run yet.
%
% CALL: STATE = nestLevels (STATE, PROBLEM, SAY)
%
%   STATE     struct of newState, from runs of the plan
%   PROBLEM   struct of newProblem; without coarse nothing is done
%   SAY       handle, gets one line of text
%
% The plan is run at the cheapest level. How far the others are from it is best
% known where it matters: at the set that the cheap runs find. A set that is run
% at two levels tells their difference alone.
%
% See also: newPlan, improveByInfill, chooseLevels

function state = nestLevels (state, problem, say)
  if isempty (problem.coarse)
    return
  end
  levels = flipud (problem.coarse.levels);     % the one that counts first
  isFinished = all (isfinite (state.data.Z), 2);
  isKnown = ismember (levels, state.data.E(isFinished, :), 'rows');
  E = levels(~isKnown, :);
  if isempty (E) || budgetLeft (state, problem) < 1
    return
  end
  P = repmat (state.found.params, rows (E), 1);
  state = runAndFit (state, problem, P, 'infill', E);
  state = moveTo (state, problem);
  state = bookStep (state, 'infill', 0, say);
end

%!shared problem, state, f
%! pkg load stk
%! pkg load -nodeps struct optim
%! rand ('twister', 4);
%! C = struct ('names', {{'a', 'b'}}, 'limits', [0, 0; 1, 1], ...
%!             'targets', struct ('value', {2, 0.1}, 'tol', 0.01, ...
%!                                'model', 1));
%! C.coarse = struct ('variable', 'scaleP', 'levels', [3, 2, 1], 'models', 1);
%! problem = newProblem (C, []);
%! f = @(P, E, r) [1 + sum(P, 2), P(:, 1) - P(:, 2)] + 0.1 * (E - 1);
%! X = rand (7, 2);
%! E = 3 * ones (7, 1);
%! data = addRows (newData (2, 2, 1), X, f (X, E, 1), ones (7, 1), ...
%!                 'plan', E);
%! s = fitSurrogates (data, problem);
%! state = newState (data, s, calibrateOnKriging (s, problem));
%! state.evaluate = plainEvaluate (f);

%!test
%! % one run at each level that has none, at the set that the coarse runs find
%! nested = nestLevels (state, problem, @(text) []);
%! assert (nested.data.E(8:end), [1; 2]);
%! assert (nested.data.X(8:end, :), repmat (state.found.params, 2, 1));
%! assert (nested.data.stage(8:end), {'infill'; 'infill'});
%! assert (isequal (nestLevels (nested, problem, @(text) []), nested));

%!test
%! % nothing without levels, nor without a budget
%! plain = problem;
%! plain.coarse = [];
%! assert (isequal (nestLevels (state, plain, []), state));
%! problem.options.maxFunEvals = 0;
%! assert (isequal (nestLevels (state, problem, []), state));
