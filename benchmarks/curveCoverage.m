% CURVECOVERAGE  Do intervals hold the truth where a curve is the target?
%
% CALL: octave-cli benchmarks/curveCoverage.m [SEEDS] [CSVFILE] [POINTS]
% CALL: octave-cli benchmarks/curveCoverage.m report CSVFILE...
%
% SEEDS    e.g. 1:50 (default), one synthetic measurement each
% CSVFILE  a row a parameter, after every measurement: seed, way, parameter,
%          truth, low, high (box widths); 'report CSVFILE...' sums such files up
% POINTS   of the curve (50)
%
% Three parameters are calibrated on a discharge curve whose errors are
% correlated over a fifth of it, and on two scalars. The truth is drawn from the
% box, flat as the prior. One packing of the measurement scatters along the
% curve as the runs do. Surrogates: one plan of 30 runs in a call. Ways: 1 the
% length of the correlation given, 2 estimated, 3 the points treated as
% independent.
%
% See also: coverage, parameterPosterior, curveErrors

1;

function Z = response (P, t)
  Z = 100 * (1 - exp (-(0.5 + P(:, 1)) .* t)) .* ...
      (1 - 0.15 * P(:, 2) .* t / max (t)) .* (1 - 0.1 * P(:, 3));
  Z = [Z, 3 + 2 * P(:, 2) + P(:, 1) .* P(:, 3), P(:, 3) - 0.5 * P(:, 1)];
end

% Scatter of one packing: alike along the curve.
function E = scatter (n, lab)
  E = [0.3 * randn(n, lab.n) * lab.packing, 0.03 * randn(n, 2)];
end

function lab = newLab (n)
  lab.n = n;
  lab.t = (1:n) / n * 3;
  smooth = @(L) chol (exp (-abs (lab.t - lab.t') / L) + 1e-9 * eye (n));
  lab.length = 0.6;
  lab.packing = smooth (1);
  lab.error = smooth (lab.length);
  lab.sd = [ones(1, n), 0.1, 0.05];
end

function problem = problemOf (lab, value, way)
  T = struct ('name', cellstr (num2str ((1:lab.n + 2)'))', 'value', ...
              num2cell (value), 'tol', 2, 'sd', num2cell (lab.sd), ...
              'isAbsolute', true, 'role', 'calibrate', 'trials', 1, ...
              'series', 'w', 'at', num2cell ([lab.t, NaN, NaN]), ...
              'curve', num2cell ([ones(1, lab.n), 0, 0]), 'correlation', NaN);
  if way == 1
    [T.correlation] = deal (lab.length);
  elseif way == 3
    [T.curve] = deal (0);
  end
  Case = struct ('names', {{'a', 'b', 'c'}}, ...
                 'limits', [0, 0, 0; 1, 1, 1], 'targets', T);
  problem = newProblem (Case, []);
end

function surrogates = newSurrogates (lab, seed)
  rand ('twister', 1e6 + seed);
  randn ('twister', 1e6 + seed);
  X = double (stk_sampling_maximinlhs (30, 3, [0, 0, 0; 1, 1, 1], 200));
  Z = response (X, lab.t) + scatter (30, lab);
  data = addRows (newData (3, lab.n + 2), X, Z, ones (30, 1), 'plan');
  surrogates = fitSurrogates (data, problemOf (lab, ones (1, lab.n + 2), 1));
end

function block = oneCase (surrogates, lab, seed)
  rand ('twister', seed);
  randn ('twister', seed);
  truth = rand (1, 3);
  noise = [randn(1, lab.n) * lab.error, randn(1, 2)] .* lab.sd;
  value = response (truth, lab.t) + scatter (1, lab) + noise;
  block = zeros (0, 6);
  for way = 1:3
    known = parameterPosterior (surrogates, problemOf (lab, value, way), 200);
    block = [block; repmat([seed, way], 3, 1), (1:3)', truth', ...
             known.interval90'];
  end
end

function sayTable (B)
  hit = B(:, 4) >= B(:, 5) & B(:, 4) <= B(:, 6);
  names = {'length given', 'length estimated', 'points independent'};
  printf ('| errors along the curve | in the 90 %% interval | of | %s\n', ...
          'share (90 % interval) | median width (box widths) |');
  printf ('|---|---|---|---|---|\n');
  for way = 1:3
    use = B(:, 2) == way;
    [low, high] = binomialInterval (sum (hit(use)), sum (use), 0.9);
    printf ('| %s | %d | %d | %.1f %% (%.1f to %.1f) | %.3f |\n', ...
            names{way}, sum (hit(use)), sum (use), 100 * mean (hit(use)), ...
            100 * low, 100 * high, median (B(use, 6) - B(use, 5)));
  end
end

addpath (fileparts (mfilename ('fullpath')));
startBenchmarks ();
given = argv ();
B = zeros (0, 6);
if numel (given) > 0 && strcmp (given{1}, 'report')
  for k = 2:numel (given)
    B = [B; csvread(given{k})];
  end
else
  seeds = [1, 50];
  if numel (given) > 0
    seeds = sscanf (given{1}, '%d:%d');
  end
  points = 50;
  if numel (given) > 2
    points = str2double (given{3});
  end
  lab = newLab (points);
  surrogates = newSurrogates (lab, seeds(1));
  for seed = seeds(1):seeds(end)
    B = [B; oneCase(surrogates, lab, seed)];
    if numel (given) > 1
      csvwrite (given{2}, B, 'precision', '%.10g');
    end
  end
end
sayTable (B);
