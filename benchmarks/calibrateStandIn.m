% CALIBRATESTANDIN  One calibration of a stand-in, as DEcalioc does it.
%
% CALL: result = calibrateStandIn (S, seed, fail, options)
%
% S        struct of standIn; S.wrong (optional): share of the runs that are
%          wrong without failing, every response off by 10 to 40 % either way;
%          S.levels (optional): L x 1, the last one counts, with S.atLevel
%          (handle (P, level) -> n x T) and S.seconds (1 x L, cost of a run)
% seed     integer; fail  share of the runs that give NaN
% options  struct of Case.options (what is missing has its default)
% result   struct: runs (all, failed ones too), plan, infill, verify, failed,
%          worst (largest true relative residual of the set handed back),
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
  Case.targets = struct ('name', S.targetNames, 'value', num2cell (S.value), ...
                         'tol', 0.01, 'sd', 0, 'role', 'calibrate', ...
                         'model', num2cell (S.model));
  Case.options = options;
  evaluate = @(P, replicate, varargin) noisy (S, P, fail, varargin{2:end});
  n = planSize (d);
  X = double (stk_sampling_maximinlhs (n, d, S.limits, 500));
  if isfield (S, 'levels')
    [problem, data] = levelledPlan (S, Case, X, evaluate);
  else
    problem = newProblem (Case, []);
    data = addRows (newData (d, T), X, evaluate (X, 1), ones (n, 1), 'plan');
  end
  surrogates = fitSurrogates (data, problem);
  found = calibrateOnKriging (surrogates, problem);
  state = newState (data, surrogates, found);
  state = improveByInfill (state, problem, evaluate, @(text) []);
  state = calibrateOnDEM (state, problem, evaluate, @(text) []);
  result = score (S, state);
  result.state = state;
  result.problem = problem;
end

% As newPlan has it: all rows at the cheapest level.
function [problem, data] = levelledPlan (S, Case, X, evaluate)
  Case.coarse = struct ('variable', 'scale', 'levels', S.levels(:)', ...
                        'models', 1);
  problem = newProblem (Case, []);
  problem.levelSeconds = @() S.seconds;
  [d, T] = deal (columns (X), numel (S.value));
  E = S.levels(ones (rows (X), 1));
  Z = evaluate (X, 1, 'plan', E);
  data = addRows (newData (d, T, 1), X, Z, ones (rows (X), 1), 'plan', E);
end

function Z = noisy (S, P, fail, E)
  if nargin > 3
    Z = S.atLevel (P, E);
  else
    Z = S.response (P);
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
  result.runs = rows (state.data.X);
  result.plan = sum (strcmp (state.data.stage, 'plan'));
  result.infill = state.spent.infill;
  result.verify = state.spent.verify;
  result.failed = sum (any (isnan (state.data.Z), 2));
  result.worst = off (S.response (state.final.params));
  result.firstObserved = first (off (state.data.Z) < 0.01);
  result.firstTrue = first (off (S.response (state.data.X)) < 0.01);
  result.converged = state.final.converged;
  result.probability = state.final.probability;
  result.params = state.final.params;
  result.cost = result.runs;
  if isfield (S, 'levels')
    [~, at] = ismember (state.data.E, S.levels(:));
    result.cost = sum (S.seconds(at)) / S.seconds(end);
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
