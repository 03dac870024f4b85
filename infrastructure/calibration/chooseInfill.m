% CHOOSEINFILL  Where the next DEM runs help most.
%
% CALL: [P, E] = chooseInfill (SURROGATES, PROBLEM, FOUND, N, ROUND)
%
% SURROGATES  1 x T struct array of fitSurrogates
% PROBLEM     struct of newProblem
% FOUND       struct of calibrateOnKriging
% N           number of runs that can go at once
% ROUND       integer, makes the draws of each round their own
% P           n x d
% E           n x v, levels of the runs; [] where PROBLEM.coarse has none
%
% Criterion: the first run goes to the set that most probably meets all
% targets (found). Each further one goes where one draw of the posterior says
% that the targets are met best (Thompson sampling, least sum of squared
% residuals in tolerances), as the first may be wrong; when the found set is
% likely (one half and more) they are its replicates. Where there are levels,
% chooseLevels takes from five such sets what gains most per core-second.
%
% See also: improveByInfill, mostProbableSet

function [P, E] = chooseInfill (surrogates, problem, found, n, round)
  E = [];
  if isempty (problem.coarse)
    P = likelySets (surrogates, problem, found, n, round);
  else
    P = likelySets (surrogates, problem, found, max (n, 5), round);
    [P, E] = chooseLevels (surrogates, problem, unique (P, 'rows'), n);
  end
end

function P = likelySets (surrogates, problem, found, n, round)
  P = repmat (found.params, n, 1);
  if n < 2 || found.probability >= 0.5
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
%! found = state.found;
%! assert (chooseInfill (s, problem, found, 1, 1), found.params);
%! found.probability = 0.9;
%! assert (chooseInfill (s, problem, found, 2, 1), ...
%!         repmat (found.params, 2, 1));
%! found.probability = 0.1;
%! before = randn ('twister');
%! P = chooseInfill (s, problem, found, 3, 1);
%! assert (randn ('twister'), before);
%! assert (size (P), [3, 2]);
%! assert (P, chooseInfill (s, problem, found, 3, 1));
%! assert (all (P(:) >= 0));
