% IMPROVEBYINFILL  Adds DEM runs where they help to find the set, and refits.
%
% CALL: STATE = improveByInfill (STATE, PROBLEM, EVALUATE, SAY)
%
% STATE     struct of newState
% PROBLEM   struct of newProblem
% EVALUATE  handle Z = evaluate (P, replicate)
% SAY       handle, gets one line of text a round
%
% Each round places a batch of options.sets runs (chooseInfill), refits the
% surrogates and calibrates again, until the found set meets all targets with a
% probability of 0.8 (the confirming runs of calibrateOnDEM bring the rest), or
% it is clear in two rounds running that no set can meet them, or only the
% runs for confirmation are left of the budget. STATE.reason says which.
% Where there are levels, the first round is that of nestLevels.
%
% Coarse runs cost at most as much as the runs at the level that counts have
% cost: however sure the coarse ones make the surrogates, they are held against
% fine ones in time, and a level that misleads costs no more than it would save.
%
% See also: nestLevels, chooseInfill, calibrateOnDEM

function state = improveByInfill (state, problem, evaluate, say)
  enough = 0.8;
  conflicts = 0;
  round = 0;
  state = nestLevels (state, problem, evaluate, say);
  while true
    conflicts = (conflicts + 1) * ~isempty (state.found.conflict);
    free = budgetLeft (state, problem) - problem.options.replicates;
    if state.found.probability >= enough
      state.reason = 'the found set is likely';
    elseif conflicts > 2
      state.reason = ['no set meets: ', ...
                      strjoin(state.found.conflict, ', ')];
    elseif free < 1
      state.reason = 'no runs left for infill';
    else
      round = round + 1;
      n = min (free, max (1, floor (problem.options.sets)));
      [P, E] = chooseInfill (state.surrogates, withPrices (problem, state), ...
                             state.found, n, round);
      state = runRows (state, problem, evaluate, P, 'infill', E);
      state = moveTo (state, problem);
      state = bookStep (state, 'infill', round, say);
      continue
    end
    break
  end
end

% Coarse runs are out of reach where enough has been spent on them.
function problem = withPrices (problem, state)
  seconds = problem.levelSeconds ();
  if isempty (problem.coarse) || isempty (seconds)
    return
  end
  [~, level] = ismember (state.data.E, problem.coarse.levels, 'rows');
  spent = accumarray (level(level > 0), 1, [numel(seconds), 1])' .* seconds;
  if sum (spent(1:end - 1)) >= spent(end)
    seconds(1:end - 1) = Inf;
    problem.levelSeconds = @() seconds;
  end
end

%!shared problem, state, s
%! [problem, state, s] = smallCalibration ();

%!test
%! % nothing to spend: said; a set out of reach: said, with few runs
%! problem.newSets = @() 0;
%! state.found.probability = 0;
%! out = improveByInfill (state, problem, @(P, r) error ('run'), @(x) []);
%! assert (out.reason, 'no runs left for infill');
%! assert (out.spent.infill, 0);
%! problem.newSets = @() Inf;
%! problem.value(2) = 9;
%! state.found = calibrateOnKriging (s, problem);
%! f = @(P, r) [3 + P(:, 1) + P(:, 2) / 2, 1 + P(:, 1) + P(:, 2) / 2.5];
%! out = improveByInfill (state, problem, f, @(x) []);
%! assert (strncmp (out.reason, 'no set meets: y', 15));
%! assert (out.spent.infill < 10);
