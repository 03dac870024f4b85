% INFILLTHOMPSON  Criterion for the next DEM runs: draws of the surrogates.
%
% CALL: P = infillThompson (STATE, PROBLEM, N, ROUND)
%
% STATE    struct of newState; surrogates and found are read
% N        number of sets
% ROUND    integer, makes the draws of each round their own
% P        n x d; a set may stand twice (replicates)
%
% The first run goes to the set that most probably meets all targets (found).
% Each further one goes where one draw of the posterior says that the targets
% are met best (Thompson sampling, least sum of squared residuals in
% tolerances), as the first may be wrong; when the found set is likely
% (options.even) they are its replicates.

function P = infillThompson (state, problem, n, round)
  surrogates = state.surrogates;
  found = state.found;
  P = repmat (found.params, n, 1);
  if n < 2 || found.probability >= problem.options.even
    return
  end
  candidates = candidateSets (surrogates, problem, found);
  loss = zeros (rows (candidates), n - 1);
  restore = seedRandom (problem.options.seed + 7919 * round);
  for t = find (problem.calibrate)
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
  sample = toAllowed (sampleBox (1000, problem.limits), problem);
  near = double (stk_sampling_halton_rr2 (100, d, [-ones(1, d); ones(1, d)]));
  P = [sample; setsAround(found.params, 0.15 * near, problem)];
  [r, s] = residualSpread (surrogates, problem, P);
  [share, spread] = toleranceShare (problem, r, s);
  optimist = max (share - 2 * spread, 0);
  [~, order] = sort (sum (optimist.^2, 2));
  C = P(order(1:200), :);
end

% N responses without the noise of a run, rows (P) x n; the sets of one draw
% vary together.
function draw = drawSurrogate (surrogate, P, n)
  [m, ~, S] = krigingPosterior (surrogate, P);
  S = (S + S') / 2 + 1e-8 * mean (diag (S)) * full (eye (rows (S)));
  draw = m + covarianceRoot (S) * randn (rows (S), n);
  draw = surrogate.shift + surrogate.scale * draw;
end

%!test
%! % alone: the found set; likely: its replicates; else draws of their own
%! [problem, state] = smallCalibration ();
%! assert (infillThompson (state, problem, 1, 1), state.found.params);
%! state.found.probability = 0.9;
%! assert (infillThompson (state, problem, 2, 1), ...
%!         repmat (state.found.params, 2, 1));
%! state.found.probability = 0.1;
%! before = randn ('twister');
%! P = infillThompson (state, problem, 3, 1);
%! assert (randn ('twister'), before);
%! assert (size (P), [3, 2]);
%! assert (P, infillThompson (state, problem, 3, 1));
%! assert (all (P(:) >= 0));

%!test
%! % draws have the mean and the spread of the surrogate: where 60 of them meet
%! % the target, it is so many deviations from the mean (4 standard errors)
%! rand ('twister', 1);
%! randn ('twister', 1);
%! problem = smallProblem (1.5, 0.05);
%! X = (0:0.1:1)';
%! s = fitSurrogate (X, 1 + X + 0.1 * randn (11, 1), [0; 1], ...
%!                   struct ('trend', 'affine'));
%! state = newState ([], s, struct ('params', 0.5, 'probability', 0));
%! P = infillThompson (state, problem, 61, 1)(2:end);
%! [m, v] = predictSurrogate (s, P);
%! z = (m - 1.5) ./ sqrt (v / s.factor);
%! assert ([mean(z), std(z)], [0, 1], [4, 4 / sqrt(2)] / sqrt (60));
