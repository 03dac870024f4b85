% SPENDRUNS  Makes DEM runs for the diagnosis, within its budget.
%
% CALL: STATE = spendRuns (STATE, PROBLEM, THETA, PHI, REPLICATE, STAGE)
%
%   STATE       of newGapState; comes back with the rows that addRuns adds
%   PROBLEM     struct of newProblem
%   THETA       n x p, parameters in [-1, 1];  PHI  n x K, strengths
%   REPLICATE   n x 1
%   STAGE       'gap' (default), 'cure', see diagnoseMatrices, or 'coarse': as
%               'gap', at the first level of a case with levels

function state = spendRuns (state, problem, theta, phi, replicate, stage)
  if nargin < 6
    stage = 'gap';
  end
  n = rows (theta);
  if isempty (state.evaluate) || min (n, state.budget.sets) < 1
    return
  end
  E = valuesOfStrength (problem.effects, phi);
  if strcmp (stage, 'coarse')
    % the coarsest level is cheapest; what it changes of an effect is learned
    % (levelShare)
    E = [repmat(problem.coarse.levels(1, :), n, 1), E];
    stage = 'gap';
  end
  state = addRuns (state, problem, fromSymmetric (theta, problem.limits), ...
                   E, stage, replicate);
end

%!function [state, problem] = before (n, left, evaluate)
%!  lab = standInGap (0);
%!  problem = newProblem (setfield (lab.problem, 'value', ...
%!                                        ones (1, 24)));
%!  options = gapOptions (struct ('maxNewRuns', left));
%!  state = newGapState (lab.plan (n, 0), options, evaluate);
%!endfunction
%!test
%! lab = standInGap (0);
%! f = @(X, E, r, stage) lab.means (X, [E, zeros(rows (E), 2)]) + ...
%!                       1e3 * strcmp (stage, 'cure');
%! [state, problem] = before (5, 4, f);
%! state = spendRuns (state, problem, zeros (3, 4), zeros (3, 10), ...
%!                    ones (3, 1));
%! assert ([state.budget.new, state.budget.sets, rows(state.data.Z)], [3, 1, 8]);
%! assert (state.data.X(6, :), 0.5 * ones (1, 4));
%! state = spendRuns (state, problem, zeros (9, 4), zeros (9, 10), ...
%!                    ones (9, 1), 'cure');
%! assert (state.data.Z(9, :), 1e3 + state.data.Z(8, :), 1e-9);
%! assert (state.data.stage, [repmat({'import'}, 5, 1); ...
%!                            repmat({'gap'}, 3, 1); {'cure'}]);
%!test % a failed set has taken the runs of two
%! [state, problem] = before (5, 9, @(X, E, r) [NaN; 1; NaN] * ones (1, 24));
%! state = spendRuns (state, problem, zeros (3, 4), zeros (3, 10), ...
%!                    ones (3, 1));
%! assert ([state.budget.new, state.budget.failed, state.budget.sets], [3, 2, 4]);
%!test % coarse runs are made at the first level and known as such
%! [state, problem] = before (5, 9, @(X, E, r) E(:, 1) * ones (1, 24));
%! problem.coarse = struct ('levels', [2; 1], 'column', ones (1, 24));
%! state.data.level = zeros (5, 24);
%! K = columns (state.data.E);
%! state = spendRuns (state, problem, zeros (2, 4), zeros (2, 10), ...
%!                    ones (2, 1), 'coarse');
%! state = spendRuns (state, problem, 0.1 * ones (1, 4), zeros (1, 10), 1);
%! assert (size (state.data.E), [8, K]);
%! assert (state.data.Z(6:8, 1)', [2, 2, 0]);
%! assert (state.data.level(5:8, 3)', [0, 1, 1, 0]);

% SPDX-License-Identifier: GPL-3.0-only
