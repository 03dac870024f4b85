% RUNNEARNULL  Runs neutral sets around the fitted null model.
%
% CALL: STATE = runNearNull (PROBLEM, STATE, THETA, N, WIDTH, SEED)
%
%   PROBLEM, STATE     of newProblem, newGapState
%   THETA   1 x p, the fitted null model, parameters in [-1, 1]
%   N       number of sets;  WIDTH  of the box around THETA, of these units
%   SEED    another one gives other sets
%
% See also: calibrateNull, spendRuns

function state = runNearNull (problem, state, theta, n, width, seed)
  spread = integrationPoints (n, numel (theta), seed).uniform - 0.5;
  % a cube about the fitted set, cut at the limits of the box
  near = min (max (theta + width * spread, -1), 1);
  state = spendRuns (state, problem, near, ...
                     zeros (n, numel (problem.effects)), ones (n, 1));
end

%!test
%! % in the middle, and at a limit of the box; another seed, other sets
%! lab = standInGap (0);
%! given = setfield (lab.problem, 'value', ones (1, 24));
%! problem = setfield (newProblem (given), 'unit', ones (1, 24));
%! state = newGapState (lab.plan (5, 0), ...
%!                      gapOptions (struct ('maxNewRuns', 9)), ...
%!                      @(X, E, r) ones (rows (X), 24));
%! state = runNearNull (problem, state, [0, 0, 0, 1], 4, 0.5, 1);
%! state = runNearNull (problem, state, [0, 0, 0, 1], 4, 0.5, 2);
%! X = state.data.X(6:end, :);
%! assert (rows (unique (X, 'rows')), 8);
%! assert (all (abs (X(:, 1:3)(:) - 0.5) <= 0.125));
%! assert (all (X(:, 4) >= 0.875 & X(:, 4) <= 1));
%! neutral = [problem.effects.neutral];
%! assert (state.data.E(6:end, :), repmat (neutral, 8, 1));

% SPDX-License-Identifier: GPL-3.0-only
