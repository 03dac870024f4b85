% CHOOSEINFILL  Where the next DEM runs help most.
%
% CALL: [P, E] = chooseInfill (STATE, PROBLEM, N, ROUND)
%
% STATE    struct of newState
% PROBLEM  struct of newProblem
% N        number of runs that can go at once
% ROUND    integer, makes the draws of each round their own
% P        n x d
% E        n x v, levels of the runs
%
% Criterion: the first run goes to the set that most probably meets all
% targets (found). Each further one goes where one draw of the posterior says
% that the targets are met best (Thompson sampling, least sum of squared
% residuals in tolerances), as the first may be wrong; when the found set is
% likely (one half and more) they are its replicates. Where there are levels,
% chooseLevels takes from five such sets what gains most per core-second. Coarse
% runs cost at most as much as the runs at the level that counts have cost:
% however sure the coarse ones make the surrogates, they are held against fine
% ones in time, and a level that misleads costs no more than it would save.
%
% See also: improveByInfill, mostProbableSet

function [P, E] = chooseInfill (state, problem, n, round)
  surrogates = state.surrogates;
  found = state.found;
  E = zeros (n, 0);
  if isempty (problem.coarse)
    P = likelySets (surrogates, problem, found, n, round);
  else
    P = likelySets (surrogates, problem, found, max (n, 5), round);
    [P, E] = chooseLevels (surrogates, problem, unique (P, 'rows'), n, ...
                           pricesOf (state, problem));
  end
end

% Coarse runs are out of reach where enough has been spent on them.
function seconds = pricesOf (state, problem)
  seconds = levelSeconds (state, problem);
  if isempty (seconds)
    return
  end
  [~, level] = ismember (state.data.E, problem.coarse.levels, 'rows');
  spent = accumarray (level(level > 0), 1, [numel(seconds), 1])' .* seconds;
  if sum (spent(1:end - 1)) >= spent(end)
    seconds(1:end - 1) = Inf;
  end
end

function P = likelySets (surrogates, problem, found, n, round)
  P = repmat (found.params, n, 1);
  if n < 2 || found.probability >= problem.options.even
    return
  end
  candidates = candidateSets (surrogates, problem, found);
  use = problem.calibrate;
  loss = zeros (rows (candidates), n - 1);
  restore = seedRandom (problem.options.seed + 7919 * round);
  for t = find (use)
    draw = drawSurrogate (surrogates(t), candidates, n - 1);
    for k = 1:n - 1
      Z = repmat (problem.value, rows (candidates), 1);
      Z(:, t) = draw(:, k);
      r = targetResidual (problem, candidates, Z);
      loss(:, k) = loss(:, k) + (r(:, t) / problem.part(t)).^2;
    end
  end
  for k = 1:n - 1
    [~, best] = min (loss(:, k));
    P(k + 1, :) = candidates(best, :);
    loss(best, :) = Inf;
  end
end

function C = candidateSets (surrogates, problem, found)
  d = columns (problem.limits);
  sample = double (stk_sampling_halton_rr2 (1000, d, problem.limits));
  near = double (stk_sampling_halton_rr2 (100, d, [-ones(1, d); ones(1, d)]));
  P = [sample; setsAround(found.params, 0.15 * near, problem.limits)];
  [r, s] = residualSpread (surrogates, problem, P);
  [share, spread] = toleranceShare (problem, r, s);
  optimist = max (share - 2 * spread, 0);
  [~, order] = sort (sum (optimist.^2, 2));
  C = P(order(1:200), :);
end

%!shared problem, state, s
%! [problem, state, s] = smallCalibration ();

%!test
%! % alone: the found set; likely: its replicates; else draws of their own
%! assert (chooseInfill (state, problem, 1, 1), state.found.params);
%! state.found.probability = 0.9;
%! assert (chooseInfill (state, problem, 2, 1), ...
%!         repmat (state.found.params, 2, 1));
%! state.found.probability = 0.1;
%! before = randn ('twister');
%! P = chooseInfill (state, problem, 3, 1);
%! assert (randn ('twister'), before);
%! assert (size (P), [3, 2]);
%! assert (P, chooseInfill (state, problem, 3, 1));
%! assert (all (P(:) >= 0));
