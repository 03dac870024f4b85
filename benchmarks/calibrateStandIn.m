% CALIBRATESTANDIN  One calibration of a stand-in, as DEcalioc does it.
%
% CALL: result = calibrateStandIn (S, seed, fail, options)
%
% S        struct of standIn; S.wrong (optional): share of the runs that are
%          wrong without failing, every response off by 10 to 40 % either way;
%          S.levels (optional): L x 1, the last one counts, with S.atLevel
%          (handle (P, level) -> n x T) and S.seconds (1 x L, cost of a run)
%          S.allowed (optional): see isAllowed
% seed     integer; fail  share of the runs that give NaN
%          S.tol (optional): 1 x T, relative tolerances (0.01); S.chance, S.part
%          (optional, bentStandIn): a run gives S.part of S.flow with a chance;
%          S.earlier: so many packings of one set before, which tell of the noise;
%          S.library: rows of newData of other calibrations on the same bench, or
%          imported ones;
%          S.beyond: see nearRows; S.form: see fitSurrogates; S.shape, S.others: see
%          knownShapes;
%          S.cost: see newProblem;
%          S.plan: runs of the plan (d + 3)
% options  struct of Case.options (what is missing has its default)
% result   struct: runs (all, failed ones too), plan, infill, verify, failed,
%          worst (largest true relative residual of the set handed back), right
%          (within all tolerances),
%          firstObserved, firstTrue (run that first looked, was right; NaN),
%          converged, probability, params, state, problem, cost (in runs at the
%          level that counts)
%
% See also: standIn, peers, coverage

function result = calibrateStandIn (S, seed, fail, options)
  rand ('twister', seed);
  randn ('twister', seed);
  d = numel (S.names);
  T = numel (S.value);
  Case = struct ('names', {S.names}, 'limits', S.limits);
  Case.allowed = givenField (S, 'allowed', []);
  Case.targets = struct ('name', S.targetNames, 'value', num2cell (S.value), ...
                         'tol', num2cell (toleranceOf (S)), 'sd', 0, ...
                         'role', 'calibrate', 'model', num2cell (S.model));
  Case.options = options;
  evaluate = @(P, E, replicate) noisy (S, P, fail, E);
  levels = [];
  n = givenField (S, 'plan', d + 3);
  X = double (stk_sampling_maximinlhs (n, d, [zeros(1, d); ones(1, d)], 500));
  X = toAllowed (fromUnit (X, S.limits), Case);
  E = zeros (n, 0);
  if isfield (S, 'levels')               % all rows at the cheapest, see newPlan
    Case.coarse = struct ('variable', 'scale', 'levels', S.levels(:)', ...
                          'models', 1);
    levels = [S.levels(:), S.seconds(:)];
    E = S.levels(ones (n, 1));
  end
  problem = newProblem (Case, givenField (S, 'cost', []));
  problem.form = givenField (S, 'form', []);
  problem.shape = givenField (S, 'shape', {});
  problem.others = givenField (S, 'others', []);
  problem = withScatter (problem, S);
  state = newState (newData (d, T, columns (E)));
  [state.evaluate, state.budget] = newEvaluate (evaluate);
  state.budget.levels = levels;
  if isfield (S, 'library')
    [state, X, E] = besideLibrary (state, S, Case, problem);
  end
  state = planToSet (state, problem, X, E);
  [state, text] = keepApart (state, problem);
  if ~isempty (text)
    [X, E] = newPlan (state.data, planCase (Case));
    state = planToSet (state, problem, X, E);
  end
  result = score (S, state);
  result.state = state;
  result.problem = problem;
end

% As calibrateCase does it.
function state = planToSet (state, problem, X, E)
  state = addRuns (state, problem, X, E, 'plan');
  state.surrogates = fitSurrogates (state.data, problem);
  state = repeatSuspects (state, problem);
  state.found = calibrateOnKriging (state.surrogates, problem);
  state.found = stayAtRuns (state, problem);
  if strcmp (problem.options.method, 'robust')
    state = improveByInfill (state, problem, @(text) []);
  end
  state = calibrateOnDEM (state, problem, @(text) []);
end

function problem = withScatter (problem, S)
  n = givenField (S, 'earlier', 0);
  if n > 0
    runs = 1 + S.noise .* randn (n, numel (S.value));
    problem.earlierSd = abs (S.value) .* std (runs) ./ mean (runs);
    problem.earlierRuns(:) = n;
  end
end

function tol = toleranceOf (S)
  tol = 0.01 * ones (1, numel (S.value));
  if isfield (S, 'tol')
    tol = S.tol;
  end
end

function Case = planCase (Case)
  n = numel (Case.names) + 3;
  Case.options = mergeFields (struct ('numOfSam', n, 'seed', 1), Case.options);
  Case.models = struct ('folder', 'none');
  Case.folder = '';
end

% As calibrateCase does it.
function [state, plan, E] = besideLibrary (state, S, Case, problem)
  beyond = [];
  if isfield (S, 'beyond')
    beyond = S.beyond;
  end
  state.data = keepRows (S.library, nearRows (S.library, problem, beyond));
  state = trustLibrary (state, problem, @(text) []);
  [plan, E] = newPlan (state.data, planCase (Case));
end

function Z = noisy (S, P, fail, E)
  if columns (E) > 0
    Z = S.atLevel (P, E);
  else
    Z = S.response (P);
  end
  if isfield (S, 'chance')
    isOther = rand (rows (P), 1) < S.chance (P);
    Z = S.flow (P) .* (1 + isOther * (S.part - 1));
  end
  Z = Z .* (1 + S.noise .* randn (size (Z)));
  if isfield (S, 'wrong')
    isWrong = rand (rows (Z), 1) < S.wrong;
    off = sign (randn (size (Z))) .* (0.1 + 0.3 * rand (size (Z)));
    Z(isWrong, :) = Z(isWrong, :) .* (1 + off(isWrong, :));
  end
  Z(rand (rows (Z), 1) < fail, :) = NaN;
end

function result = score (S, state)
  off = @(Z) max (abs (Z ./ S.value - 1), [], 2);
  share = @(Z) max (abs (Z ./ S.value - 1) ./ toleranceOf (S), [], 2);
  isNew = ~ismember (state.data.stage, {'import', 'library'});
  result.runs = sum (isNew);
  result.plan = sum (strcmp (state.data.stage, 'plan'));
  result.infill = sum (strcmp (state.data.stage, 'infill'));
  result.verify = sum (isAfterPlan (state.data)) - ...
                  result.infill;
  result.failed = sum (any (isnan (state.data.Z), 2));
  result.worst = off (S.response (state.final.params));
  result.right = share (S.response (state.final.params)) < 1;
  result.firstObserved = first (share (state.data.Z) < 1);
  result.firstTrue = first (share (S.response (state.data.X)) < 1);
  result.converged = state.final.converged;
  result.probability = state.final.probability;
  result.params = state.final.params;
  result.cost = result.runs;
  if isfield (S, 'levels')
    [~, at] = ismember (state.data.E, S.levels(:));
    result.cost = sum (S.seconds(at(isNew))) / S.seconds(end);
  end
end

function i = first (hits)
  i = find (hits, 1);
  if isempty (i)
    i = NaN;
  end
end

%!test
%! % sets that are called calibrated are right (5 in 100 are not: two of three
%! % wrong by chance in 0.7 %), with a truth near a corner too (seed 3)
%! pkg load stk
%! pkg load -nodeps struct optim
%! wrong = 0;
%! for seed = 1:3
%!   r = calibrateStandIn (standIn ('shear', seed), seed, 0, struct ());
%!   assert (r.converged && r.runs < 40);
%!   wrong = wrong + (r.worst > 0.01);
%! end
%! assert (wrong < 2);

% SPDX-License-Identifier: GPL-3.0-only
