% ADDRUNS  Makes runs and adds them to the data: the one door for all runs.
%
% CALL: STATE = addRuns (STATE, PROBLEM, P, E, STAGE [, REPLICATE])
%
%   STATE      struct: data (newData), evaluate and budget (newEvaluate)
%   PROBLEM    see newProblem; limits, allowed, fine, kept and unit are read
%   P          n x d, sets; what is not allowed is not run, see toAllowed
%   E          n x v, values of the level and effect variables; []: PROBLEM.fine.
%              Columns more than the data have, in front, are levels: the data
%              hold them as level, see fitEmulator
%   STAGE      what they are for (text), see newData
%   REPLICATE  n x 1 (default: see replicateNumbers)
%
% Rows beyond BUDGET.sets are left out. A set of which a run was not made leaves
% no trace in the data. The others have there the numbers that were run
% (toDigits), and NA for models that BUDGET.models leaves out.
%
% Errors: DEcalioc:addRuns:sharedResults (two runs have the results of one, see
% equalRuns)

function state = addRuns (state, problem, P, E, stage, replicate)
  if rows (E) < rows (P)
    E = repmat (problem.fine, rows (P), 1);
  end
  P = toDigits (toAllowed (P, problem));
  E = toDigits (E);
  if nargin < 6
    replicate = replicateNumbers (state.data, P, problem.limits);
  end
  n = min (rows (P), state.budget.sets);
  [P, E, replicate] = deal (P(1:n, :), E(1:n, :), replicate(1:n)(:));
  [Z, state.budget] = state.evaluate (P, E, replicate, stage, state.budget);
  Z = Z(:, problem.kept) ./ problem.unit;
  isAsked = askedResults (state.budget, problem.bench);
  isTried = ~any (isna (Z(:, isAsked)), 2);
  Z(:, ~isAsked) = NA;
  [P, E, Z] = deal (P(isTried, :), E(isTried, :), Z(isTried, :));
  v = columns (E) - columns (state.data.E);
  state.data = addRows (state.data, P, Z, replicate(isTried), stage, ...
                        E(:, v + 1:end));
  if v > 0
    state.data.level(end - rows (E) + 1:end, :) = unitLevel (problem.coarse, ...
                                                             E(:, 1:v));
  end
  refuseShared (state.data, problem);
  % a set that fails was run twice, see runJobs
  nFailed = sum (lostRows (Z, problem.bench));
  state.budget.sets = max (state.budget.sets - n - nFailed, 0);
end

% A calibration on them would be one on numbers of other sets.
function refuseShared (data, problem)
  data = keepRows (data, ~ismember (data.stage, {'import', 'library'}));
  [pair, shared] = equalRuns (data, problem);
  if isempty (pair)
    return
  end
  at = @(row) namedValues (problem.names, data.X(row, :), '%.4g');
  values = data.Z(pair(1), shared) .* problem.unit(shared);
  error ('DEcalioc:addRuns:sharedResults', ...
         ['addRuns: each run of %s must have results of its own, got the same ones ' ...
          'to the last digit (%s) at %s and at %s. One of these runs read what another ' ...
          'one wrote: let each write into its own folder (decalioc check names places ' ...
          'outside it), then calibrate with decalioc run --afresh.'], ...
         problem.benchNames{problem.bench(shared(1))}, ...
         strjoin (arrayfun (@(v) sprintf ('%.10g', v), values, 'UniformOutput', ...
                            false), ', '), at (pair(1)), at (pair(2)));
end

%!test
%! state.data = newData (1, 1, 1);
%! [state.evaluate, state.budget] = newEvaluate ( ...
%!   @(P, E, r) merge (r > 2, NA, P + E));
%! problem = struct ('limits', [0; 9], 'fine', 0, 'kept', 1, 'unit', 1, 'bench', 1);
%! state = addRuns (state, problem, [1; 1; 1; 2], [0; 5; 0; 0], 'plan');
%! assert ([state.data.X, state.data.E, state.data.Z, ...
%!          state.data.replicate], [1, 0, 1, 1; 1, 5, 6, 2; 2, 0, 2, 1]);
%! assert (state.budget.isUsedUp);
%! state = addRuns (state, problem, 3, [], 'plan');
%! assert (state.data.E(end), 0);
%!test
%! % results come in the units of the problem, of its targets, as many as may be;
%! % a failed set has taken the runs of two; levels are no effects
%! problem = struct ('limits', [0; 9], 'kept', [1, 3], 'unit', [2, 4], 'bench', [1, 1]);
%! problem.coarse = struct ('levels', [5; 3], 'column', [1, 0]);
%! state.data = newData (1, 2, 1);
%! state.data.level = zeros (0, 2);
%! [state.evaluate, state.budget] = newEvaluate ( ...
%!   @(P, E, r) [merge(P > 1, P + sum (E, 2), NaN), 0 * P, merge(P > 1, 8 * P, NaN)]);
%! state.budget.sets = 5;
%! state = addRuns (state, problem, [1; 2; 3], [5, 7; 3, 7; 4, 7], 'gap');
%! assert (state.data.Z(2:3, :), [6, 4; 7, 6]);
%! assert ([state.data.E, state.data.level], [7, 1, 0; 7, 0, 0; 7, 0.5, 0]);
%! assert (state.budget.sets, 1);
%! state = addRuns (state, problem, [4; 5], [7; 7], 'gap');
%! assert ([rows(state.data.X), state.data.level(end, :)], [4, 0, 0]);
%!test
%! % of two models one is run: the other one has not failed
%! problem = struct ('limits', [0; 9], 'fine', 0, 'kept', 1:2, 'unit', [1, 1], ...
%!                   'bench', [1, 2]);
%! state.data = newData (1, 2, 1);
%! [state.evaluate, state.budget] = newEvaluate (@(P, E, r) [P, NaN * P]);
%! [state.budget.models, state.budget.sets] = deal ([true, false], 9);
%! state = addRuns (state, problem, [1; 2], [], 'gap');
%! assert (state.data.Z, [1, NA; 2, NA]);
%! assert (isna (state.data.Z(:, 2)'), [true, true]);
%! assert (state.budget.sets, 7);
%!test
%! % results of another run are refused, those of another packing are not
%! problem = struct ('limits', [0; 9], 'fine', zeros (1, 0), 'kept', 1:2, 'unit', [1, 2], ...
%!                   'bench', [1, 1], 'names', {{'a'}}, 'benchNames', {{'Rig'}});
%! state.data = newData (1, 2);
%! f = @(P) [pi * P, 10 - exp(P)];
%! [state.evaluate, state.budget] = newEvaluate (@(P, E, r) f (P));
%! state = addRuns (state, problem, [1; 1; 2; 3; 4], [], 'plan');
%! state.evaluate = newEvaluate (@(P, E, r) f (2 + 0 * P));
%! fail ('addRuns (state, problem, 5, [], ''infill'')', ...
%!       'each run of Rig .*6.283185307, 2.610943901.* at a = 2 and at a = 5');
%!error id=DEcalioc:addRuns:sharedResults ...
%! problem = struct ('limits', [0; 9], 'fine', zeros (1, 0), 'kept', 1:2, 'unit', [1, 2], ...
%!                   'bench', [1, 1], 'names', {{'a'}}, 'benchNames', {{'Rig'}});
%! state.data = addRows (newData (1, 2), [1; 2; 3], [pi, 9; 4.123456, 8.123456; 7, 7], ...
%!                       [1; 1; 1], 'plan');
%! [state.evaluate, state.budget] = newEvaluate (@(P, E, r) [4.123456, 16.246912]);
%! addRuns (state, problem, 5, [], 'infill');

% SPDX-License-Identifier: GPL-3.0-only
