% RUNANDFIT  Makes runs after the plan and refits the surrogates.
%
% CALL: STATE = runAndFit (STATE, PROBLEM, P, STAGE [, E])
%
% P      n x d  sets; one that stands in the data already (or twice in P) is
%        another packing (replicateNumbers)
% STAGE  'infill', 'verify', 'replicate' or 'interval'
% E      n x v, see addRuns (PROBLEM.fine)
%
% Runs that look wrong then are run once more (repeatSuspects). Never more rows
% than the budget has: what is over is left out.

function state = runAndFit (state, problem, P, stage, E)
  n = min (rows (P), budgetLeft (state, problem));
  if n < 1
    return
  end
  if nargin < 5
    E = repmat (problem.fine, n, 1);
  end
  P = besideEqualRuns (P(1:n, :), state.data, problem);
  state = addRuns (state, problem, P, E(1:n, :), stage);
  state.surrogates = fitSurrogates (state.data, problem, state.surrogates);
  state = repeatSuspects (state, problem);
end

% Where a model has shown that it does not use runSeed, another packing is one
% at a set beside: up to 1 % of the box away.
function P = besideEqualRuns (P, data, problem)
  again = replicateNumbers (data, P, problem.limits) > 1;
  [~, isRepeat] = countEqualOnce (data, problem.bench);
  if any (isRepeat) && any (again)
    step = zeros (size (P));
    step(again, :) = 0.02 * (rand (sum (again), columns (P)) - 0.5);
    P = setsAround (P, step, problem);
  end
end

%!function [problem, state] = planned (f, coarse)
%!  C = struct ('names', {{'a'}}, 'limits', [0; 1], 'coarse', {coarse}, ...
%!              'targets', struct ('value', 1.5, 'tol', 0.05, 'model', 1));
%!  problem = newProblem (C, []);
%!  X = (0:7)' / 7;
%!  E = repmat ([2; 1], 4, ~isempty (coarse));
%!  data = addRows (newData (1, 1, columns (E)), X, 1 + X + sum (E, 2), ...
%!                  ones (8, 1), 'plan', E);
%!  state = newState (data, fitSurrogates (data, problem), []);
%!  state.evaluate = newEvaluate (f);
%!endfunction

%!test
%! [problem, state] = planned (@(P, E, r) 1 + P + 0 ./ (r < 3), []);
%! problem.options.maxFunEvals = 3;
%! state = runAndFit (state, problem, [0.45; 0.45; 0.45; 0.45], 'verify');
%! assert (state.data.replicate(9:end), [1; 2; 3]);
%! assert (budgetLeft (state, problem), 0);
%! assert (isnan (state.data.Z), [false(10, 1); true]);

%!test
%! % a set that the budget leaves out is no failure
%! [problem, state] = planned (@(P, E, r) merge (r > 1, NA, 1 + P), []);
%! state = runAndFit (state, problem, [0.5; 0.5], 'infill');
%! assert (all (isfinite (state.data.Z)) && rows (state.data.Z) == 9);

%!test
%! % with levels: the given ones, else the one that counts
%! coarse = struct ('variable', 'scaleP', 'levels', [2, 1], 'models', 1);
%! [problem, state] = planned (@(P, E, r) 1 + P + E, coarse);
%! state = runAndFit (state, problem, [0.5; 0.6], 'infill', [2; 1]);
%! state = runAndFit (state, problem, 0.5, 'verify');
%! assert (state.data.E(9:end), [2; 1; 1]);
%! assert (state.data.Z(9:end), [3.5; 2.6; 2.5], 1e-12);
%! assert (state.data.replicate(9:end), [1; 1; 2]);

% SPDX-License-Identifier: GPL-3.0-only
