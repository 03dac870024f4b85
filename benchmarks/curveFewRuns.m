% CURVEFEWRUNS  Do parameter intervals hold after few runs on a curve?
%
% CALL: octave-cli benchmarks/curveFewRuns.m SEEDS [CSVFILE] [PLAN] [intervals]
%
% SEEDS    e.g. 1:30
% CSVFILE  one row a seed: seed, runs, converged, probability, off (true
%          deviation of the found set, root mean square along the curve in
%          tolerances, which is what a curve is judged by), then for each of the
%          three parameters truth, low, high (90 % interval) in box widths
%
% intervals  with the runs that Input.intervals = true asks for
%
% Each seed draws a set from the box, takes its curve of 18 points as measured,
% to a tolerance of 2 % of its range, and calibrates three parameters on it as
% DEcalioc does: plan of d + 3 or PLAN rows, infill, confirmation, all by
% default. The curve is a rising profile whose height, slope and foot depend on
% the parameters by a product, a saturation and a kink. A run scatters along the
% curve as one, by a fifth of the tolerance. Reported: how many of the intervals
% hold the drawn set, and how wide they are.
%
% See also: curveCoverage, parameterPosterior

1;

function Z = response (U, x)
  height = 20 + 12 * U(:, 1) .* (0.6 + 0.4 * U(:, 2));
  slope = 0.4 + 0.5 * tanh (2 * U(:, 2)) + 0.15 * U(:, 3);
  foot = 6 + 3 * max (U(:, 3) - 0.4, 0) + 2 * U(:, 1);
  Z = height .* x.^(1.5 - slope) + foot .* (1 - x).^2;
end

function [problem, evaluate, truth] = newCalibrationOf (seed, intervals)
  n = 18;
  x = linspace (0.05, 0.95, n);
  restore = seedRandom (seed);
  truth = rand (1, 3);
  tol = 0.4;
  root = chol (exp (-abs (x - x') / 0.3) + 1e-9 * eye (n));
  noise = @(m) 0.2 * tol * randn (m, n) * root;
  value = response (truth, x) + noise (1);
  T = struct ('name', cellstr (num2str ((1:n)'))', 'value', ...
              num2cell (value), 'tol', tol, 'sd', NaN, 'isAbsolute', true, ...
              'role', 'calibrate', 'trials', 1, 'series', 'w', ...
              'at', num2cell (x), 'curve', 1, 'correlation', NaN, 'model', 1);
  Case = struct ('names', {{'a', 'b', 'c'}}, ...
                 'limits', [0, 0, 0; 1, 1, 1], 'targets', T);
  Case.options.seed = seed;
  Case.options.intervals = intervals;
  problem = newProblem (Case, []);
  evaluate = @(P, E, replicate) response (P, x) + noise (rows (P));
end

function row = oneSeed (seed, nPlan, intervals)
  [problem, evaluate, truth] = newCalibrationOf (seed, intervals);
  restore = seedRandom (seed);
  X = double (stk_sampling_maximinlhs (nPlan, 3, problem.limits, 500));
  Z = evaluate (X, [], 1);
  data = addRows (newData (3, columns (Z)), X, Z, ones (nPlan, 1), 'plan');
  surrogates = fitSurrogates (data, problem);
  state = newState (data, surrogates, ...
                    calibrateOnKriging (surrogates, problem));
  state.evaluate = newEvaluate (evaluate);
  say = @(text) [];
  state = improveByInfill (state, problem, say);
  state = runForIntervals (state, problem);
  state = calibrateOnDEM (state, problem, say);
  known = parameterPosterior (state.surrogates, problem);
  at = problem.coordinate;
  off = (response (state.final.params, at) - problem.value) / 0.4;
  row = [seed, rows(state.data.X), state.final.converged, ...
         state.final.probability, sqrt(mean (off.^2))];
  for k = 1:3
    row = [row, truth(k), known.interval90(:, k)'];
  end
end

function sayTable (R)
  hit = R(:, 6:3:14) >= R(:, 7:3:14) & R(:, 6:3:14) <= R(:, 8:3:14);
  [low, high] = binomialInterval (sum (hit(:)), numel (hit), 0.9);
  width = R(:, 8:3:14) - R(:, 7:3:14);
  printf (['%d seeds: %d of %d intervals hold (%.0f %%, 90 %% interval ' ...
           '%.0f to %.0f), median width %.3f %.3f %.3f; runs median %g, ' ...
           'sets truly within the tolerance %d\n'], rows (R), ...
          sum (hit(:)), numel (hit), 100 * mean (hit(:)), 100 * low, ...
          100 * high, median (width), median (R(:, 2)), sum (R(:, 5) <= 1));
end

addpath (fileparts (mfilename ('fullpath')));
startBenchmarks ();
given = argv ();
intervals = strcmp (given{end}, 'intervals');
given = given(1:end - intervals);
seeds = sscanf (given{1}, '%d:%d')';
nPlan = 6;
if numel (given) > 2
  nPlan = str2double (given{3});
end
R = zeros (0, 14);
for seed = seeds(1):seeds(end)
  R(end + 1, :) = oneSeed (seed, nPlan, intervals);
  printf ('%4d runs %3d off by %.2f hits %d\n', R(end, [1, 2, 5]), ...
          sum (R(end, 6:3:14) >= R(end, 7:3:14) & ...
               R(end, 6:3:14) <= R(end, 8:3:14)));
  if numel (given) > 1
    csvwrite (given{2}, R, 'precision', '%.8g');
  end
end
sayTable (R);
