% WRONGSTORED  Plans of stored LIGGGHTS runs: which runs are taken for wrong.
%
% CALL: octave-cli benchmarks/wrongStored.m SHARE PLANS
% CALL: octave-cli benchmarks/wrongStored.m noise
%
% SHARE  of wrong runs, 0 or 0.12;  PLANS  numbers, e.g. 101:140: drawn of each
%        store
%
% Runs of DEM scatter with wide tails, and what one run measures scatters
% together: an avalanche changes slope, height and mass at once. Each plan is a
% random part of the runs of a store: 121 runs of the template Repose with two
% parameters (storedRepose), and the neutral runs of examples/hiddenEffect and
% benchmarks/drumAndBins. All ended well. In a wrong
% run every response of one bench is off by 10 to 40 % either way. A run that
% is taken for wrong is run once more (repeatSuspects): the second run is what
% all runs of the store foretell there, off by what another run is off by.
% Prints how
% many of these findBadRuns leaves out, how many good ones, by how much the
% surrogates miss the good runs that are not in the plan (root mean square, in
% standard deviations of a response, mean over responses and plans), and how
% many of these the 90 % intervals of a run hold.
%
% With noise: what a run scatters by, over the spread of the response, as
% prepareFit expects it: surrogates of all runs of a store.
%
% See also: wrongRuns, findBadRuns, prepareFit

1;

function store = campaign (name, root)
  [given, data] = storedCampaign (name, root);
  neutral = [given.effects(~[given.effects.laboratory]).neutral];
  use = all (data.E == neutral, 2) & all (isfinite (data.Z), 2);
  Case = struct ('names', {given.names}, 'limits', given.limits);
  Case.targets = struct ('name', given.targetNames, ...
                         'value', num2cell (given.value), 'tol', 0.05, ...
                         'sd', 0, 'model', num2cell (given.bench), ...
                         'role', 'calibrate');
  [X, Z] = deal (data.X(use, :), data.Z(use, :));
  data = addRows (newData (columns (X), columns (Z)), X, Z, ...
                  ones (rows (X), 1), 'plan');
  store = struct ('data', data, 'problem', newProblem (Case));
end

% Planted, found, good ones left out (a run of a bench is one), miss, coverage.
function count = onePlan (store, n, share, number)
  rand ('twister', number);
  randn ('twister', number);
  pick = randperm (rows (store.data.X))(1:n);
  Z = store.data.Z(pick, :);
  bench = store.problem.bench;
  wrong = false (size (Z));
  for b = unique (bench)
    own = bench == b;
    at = rand (n, 1) < share;
    wrong(at, own) = true;
    off = 1 + (0.1 + 0.3 * rand (n, sum (own))) .* sign (randn (n, sum (own)));
    Z(at, own) = Z(at, own) .* off(at, :);
  end
  data = setfield (keepRows (store.data, pick), 'Z', Z);
  state = newState (data, fitSurrogates (data, store.problem), []);
  [state.evaluate, state.budget] = newEvaluate (@(P, E, r) ...
                                                repeated (P, store));
  state = repeatSuspects (state, store.problem);
  surrogates = state.surrogates;
  left = horzcat (surrogates.leftOut)(1:n, :);
  others = setdiff (1:rows (store.data.X), pick);
  [expected, variance] = predictSurrogate (surrogates, store.data.X(others, :));
  miss = expected - store.data.Z(others, :);
  wide = arrayfun (@(df) studentQuantile (0.95, df), [surrogates.df]) .* ...
         sqrt (variance + [surrogates.noiseVar]);
  [~, first] = unique (bench, 'first');
  left = left(:, first);
  wrong = wrong(:, first);
  count = [sum(wrong(:)), sum(left(wrong)), sum(left(~wrong)), ...
           mean(sqrt (mean (miss.^2, 1)) ./ std (store.data.Z)), ...
           mean(mean (abs (miss) < wide))];
end

% A second run at sets of the store: what all runs foretell, and what another
% run of the store, by chance, is off by.
function Z = repeated (P, store)
  m = predictSurrogate (store.all, P);
  residual = [store.all.looResidual];
  Z = m + residual(ceil (rand (rows (P), 1) * rows (residual)), :);
end

function store = storeOf (name, root)
  if strcmp (name, 'repose')
    store = storedRepose (root);
  else
    store = campaign (name, root);
  end
  store.all = fitSurrogates (store.data, store.problem);
end

function sayNoise (root)
  ratio = [];
  for name = {'repose', 'hiddenEffect', 'drumAndBins'}
    store = storeOf (name{1}, root);
    surrogates = fitSurrogates (store.data, store.problem);
    own = sqrt ([surrogates.noiseVar]) ./ std (store.data.Z);
    printf ('%-13s %3d runs: %s\n', name{1}, rows (store.data.X), ...
            sprintf ('%.2f ', own));
    ratio = [ratio, own];
  end
  printf (['%d responses: geometric mean %.2f, deviation of the log ' ...
           'variance %.2f\n'], numel (ratio), exp (mean (log (ratio))), ...
          2 * std (log (ratio)));
end

args = argv ();
addpath (fileparts (mfilename ('fullpath')));
root = startBenchmarks ();
pkg ('load', 'stk');
if strcmp (args{1}, 'noise')
  sayNoise (root);
  return
end
share = str2double (args{1});
numbers = str2num (args{2});
plans = numel (numbers);
stores = {'repose', 10; 'repose', 25; 'hiddenEffect', 25; 'drumAndBins', 25};
for i = 1:rows (stores)
  [name, n] = stores{i, :};
  store = storeOf (name, root);
  count = zeros (plans, 5);
  for k = 1:plans
    count(k, :) = onePlan (store, n, share, numbers(k));
  end
  hit = sum (count(:, 3) > 0);
  [lo, hi] = binomialInterval (hit, plans);
  printf (['%-13s %2d runs: %d of %d wrong ones found; good ones left out ', ...
           'in %d of %d plans (%.0f - %.0f %%), %.2f a plan; others are ', ...
           'missed by %.3f, intervals hold %.2f\n'], name, n, ...
          sum (count(:, 2)), sum (count(:, 1)), hit, plans, 100 * lo, ...
          100 * hi, mean (count(:, 3:5)));
end
