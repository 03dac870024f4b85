% SPENDRUNS  Makes DEM runs for the diagnosis, within its budget.
%
% CALL: STATE = spendRuns (STATE, GAPPROBLEM, THETA, PHI, REPLICATE, STAGE)
%
%   STATE       of newGapState; comes back with the rows added. Rows beyond
%               what is left, or that evaluate gives as NA, are left out
%   GAPPROBLEM  struct of newGapProblem
%   THETA       n x p, parameters in [-1, 1];  PHI  n x K, strengths
%   REPLICATE   n x 1
%   STAGE       'gap' (default) or 'cure', see diagnoseMatrices

function state = spendRuns (state, gapProblem, theta, phi, replicate, stage)
  if nargin < 6
    stage = 'gap';
  end
  n = min (rows (theta), state.left);
  if isempty (state.evaluate) || n < 1
    return
  end
  half = diff (gapProblem.limits) / 2;
  X = mean (gapProblem.limits) + theta(1:n, :) .* half;
  E = valuesOfStrength (gapProblem.effects, phi(1:n, :));
  before = rows (state.data.X);
  state = addRuns (state, gapProblem, X, E, stage, replicate(1:n)(:));
  Z = state.data.Z(before + 1:end, :);
  nFailed = sum (any (isnan (Z), 2));
  state.left = max (state.left - n - nFailed, 0);
  state.spent = state.spent + rows (Z);
  state.failed = state.failed + nFailed;
end

%!function [state, gapProblem] = before (n, left, evaluate)
%!  lab = standInGap (0);
%!  gapProblem = newGapProblem (setfield (lab.gapProblem, 'value', ...
%!                                        ones (1, 24)));
%!  options = gapOptions (struct ('maxNewRuns', left));
%!  state = newGapState (lab.plan (n, 0), gapProblem, options, evaluate);
%!endfunction
%!test
%! lab = standInGap (0);
%! f = @(X, E, r, stage) lab.means (X, [E, zeros(rows (E), 2)]) + ...
%!                       1e3 * strcmp (stage, 'cure');
%! [state, gapProblem] = before (5, 4, f);
%! state = spendRuns (state, gapProblem, zeros (3, 4), zeros (3, 10), ...
%!                    ones (3, 1));
%! assert ([state.spent, state.left, rows(state.data.Z)], [3, 1, 8]);
%! assert (state.data.X(6, :), 0.5 * ones (1, 4));
%! state = spendRuns (state, gapProblem, zeros (9, 4), zeros (9, 10), ...
%!                    ones (9, 1), 'cure');
%! assert (state.data.Z(9, :), 1e3 + state.data.Z(8, :), 1e-9);
%! assert (state.data.stage, [repmat({'import'}, 5, 1); ...
%!                            repmat({'gap'}, 3, 1); {'cure'}]);
%!test % a failed set has taken the runs of two
%! [state, gapProblem] = before (5, 9, @(X, E, r) [NaN; 1; NaN] * ones (1, 24));
%! state = spendRuns (state, gapProblem, zeros (3, 4), zeros (3, 10), ...
%!                    ones (3, 1));
%! assert ([state.spent, state.failed, state.left], [3, 2, 4]);
