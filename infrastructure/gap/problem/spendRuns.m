% SPENDRUNS  Makes DEM runs for the diagnosis, within its budget.
%
% CALL: STATE = spendRuns (STATE, GAPPROBLEM, THETA, PHI, REPLICATE, STAGE)
%
%   STATE       struct: data (X, E, Z, replicate, and stage where it has one),
%               evaluate (handle, [] = none), left (sets that may still be
%               run: one that fails was run twice, see runJobs), spent,
%               failed
%   GAPPROBLEM  struct of newGapProblem
%   THETA       n x p, parameters in [-1, 1];  PHI  n x K, strengths
%   REPLICATE   n x 1
%   STAGE       'gap' (default) or 'cure', see diagnoseMatrices
%   STATE       the same with the rows added; rows beyond the budget, or that
%               evaluate gives as NA, are left out
%
% See also: diagnoseMatrices, planEffectRuns

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
  told = {};
  if nargin (state.evaluate) < 0 || nargin (state.evaluate) > 3
    told = {stage};
  end
  Z = state.evaluate (X, E, replicate(1:n), told{:});
  isTried = ~any (isna (Z), 2);
  Z = Z(:, gapProblem.kept) ./ gapProblem.unit;
  state.data.X = [state.data.X; X(isTried, :)];
  state.data.E = [state.data.E; E(isTried, :)];
  state.data.Z = [state.data.Z; Z(isTried, :)];
  state.data.replicate = [state.data.replicate; replicate(isTried)(:)];
  if isfield (state.data, 'stage')
    state.data.stage = [state.data.stage; repmat({stage}, sum (isTried), 1)];
  end
  nFailed = sum (any (isnan (Z(isTried, :)), 2));
  state.left = max (state.left - n - nFailed, 0);
  state.spent = state.spent + sum (isTried);
  state.failed = state.failed + nFailed;
end

%!test
%! lab = standInGap (0);
%! given = setfield (lab.gapProblem, 'value', ones (1, 24));
%! gapProblem = newGapProblem (given);
%! state = struct ('data', lab.plan (5, 0), 'left', 3, 'spent', 0, ...
%!                 'failed', 0);
%! state.evaluate = @(X, E, r) lab.means (X, [E, zeros(rows (E), 2)]);
%! state = spendRuns (state, gapProblem, zeros (5, 4), zeros (5, 10), ...
%!                    ones (5, 1));
%! assert ([state.spent, state.left, rows(state.data.Z)], [3, 0, 8]);
%! assert (state.data.X(6, :), 0.5 * ones (1, 4));
%! state.left = 1;
%! state.evaluate = @(X, E, r, stage) strcmp (stage, 'cure') * ones (1, 24);
%! state = spendRuns (state, gapProblem, zeros (1, 4), zeros (1, 10), 1, ...
%!                    'cure');
%! assert (state.data.Z(end, :), ones (1, 24));
%!test % a failed set has taken the runs of two
%! lab = standInGap (0);
%! given = setfield (lab.gapProblem, 'value', ones (1, 24));
%! gapProblem = newGapProblem (given);
%! state = struct ('data', lab.plan (5, 0), 'left', 9, 'spent', 0, ...
%!                 'failed', 0);
%! state.evaluate = @(X, E, r) [NaN; 1; NaN] * ones (1, 24);
%! state = spendRuns (state, gapProblem, zeros (3, 4), zeros (3, 10), ...
%!                    ones (3, 1));
%! assert ([state.spent, state.failed, state.left], [3, 2, 4]);
%!test % a table of runs that tells the stage of each goes on telling it
%! lab = standInGap (0);
%! given = setfield (lab.gapProblem, 'value', ones (1, 24));
%! gapProblem = newGapProblem (given);
%! state = struct ('data', lab.plan (2, 0), 'left', 2, 'spent', 0, ...
%!                 'failed', 0);
%! state.data.stage = {'plan'; 'infill'};
%! state.evaluate = @(X, E, r, stage) ones (rows (X), 24);
%! state = spendRuns (state, gapProblem, zeros (1, 4), zeros (1, 10), 1);
%! state = spendRuns (state, gapProblem, zeros (1, 4), zeros (1, 10), 1, ...
%!                    'cure');
%! assert (state.data.stage, {'plan'; 'infill'; 'gap'; 'cure'});
