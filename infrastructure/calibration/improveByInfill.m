% IMPROVEBYINFILL  Adds DEM runs where they help to find the set, and refits.
%
% CALL: STATE = improveByInfill (STATE, PROBLEM, SAY)
%
% STATE     struct of newState
% PROBLEM   struct of newProblem
% SAY       handle, gets one line of text a round
%
% Each round places a batch of options.sets runs (chooseInfill), refits the
% surrogates and calibrates again, until the found set meets all targets with a
% probability of options.likely (the runs of calibrateOnDEM bring the rest), or
% it is clear in two rounds running that no set can meet them, or only the
% runs for confirmation are left of the budget. STATE.reason says which.
% Where there are levels, the found set is run at those that have no run yet
% first.

function state = improveByInfill (state, problem, say)
  conflicts = 0;
  round = 0;
  state = nestLevels (state, problem, say);
  while true
    conflicts = (conflicts + 1) * ~isempty (state.found.conflict);
    free = budgetLeft (state, problem) - problem.options.replicates;
    if state.found.probability >= problem.options.likely
      state.reason = 'the found set is likely';
    elseif conflicts > problem.options.conflicts
      state.reason = ['no set meets: ', ...
                      strjoin(state.found.conflict, ', ')];
    elseif free < 1
      state.reason = 'no runs left for infill';
    else
      round = round + 1;
      n = min (free, max (1, floor (problem.options.sets)));
      [P, E] = chooseInfill (state, problem, n, round);
      state = runAndFit (state, problem, P, 'infill', E);
      state = moveTo (state, problem);
      state = bookStep (state, 'infill', round, say);
      continue
    end
    break
  end
end

% The plan is run at the cheapest level. How far the others are from it is best
% known where it matters: at the set that the cheap runs find. A set that is run
% at two levels tells their difference alone.
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

%!shared problem, state, s
%! [problem, state, s] = smallCalibration ();

%!test
%! % nothing to spend: said; a set out of reach: said, with few runs
%! state.found.probability = 0;
%! state.evaluate = @(varargin) error ('run');
%! out = setfield (state, 'budget', struct ('left', 0, 'perSet', 1, ...
%!                                          'isUsedUp', true, 'levels', []));
%! out = improveByInfill (out, problem, @(x) []);
%! assert (out.reason, 'no runs left for infill');
%! problem.value(2) = 9;
%! state.found = calibrateOnKriging (s, problem);
%! state.evaluate = newEvaluate (@(P, E, r) [3 + P(:, 1) + P(:, 2) / 2, ...
%!                                             1 + P(:, 1) + P(:, 2) / 2.5]);
%! out = improveByInfill (state, problem, @(x) []);
%! assert (strncmp (out.reason, 'no set meets: y', 15));
%! assert (sum (isAfterPlan (out.data)) < 10);

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
%! state.evaluate = newEvaluate (f);

%! problem.options.maxFunEvals = 2;
%! problem.options.likely = 1.1;

%!test
%! % one run at each level that has none, at the set that the coarse runs find
%! nested = improveByInfill (state, problem, @(text) []);
%! assert (nested.data.E(8:end), [1; 2]);
%! assert (nested.data.X(8:end, :), repmat (state.found.params, 2, 1));
%! assert (nested.data.stage(8:end), {'infill'; 'infill'});
%! assert (isequal (improveByInfill (nested, problem, @(text) []), nested));
