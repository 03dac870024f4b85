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
% Where there are levels, the first round is that of nestLevels.
%
% See also: nestLevels, chooseInfill, calibrateOnDEM

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
%! state.evaluate = plainEvaluate (@(P, E, r) [3 + P(:, 1) + P(:, 2) / 2, ...
%!                                             1 + P(:, 1) + P(:, 2) / 2.5]);
%! out = improveByInfill (state, problem, @(x) []);
%! assert (strncmp (out.reason, 'no set meets: y', 15));
%! assert (sum (isAfterPlan (out.data)) < 10);
