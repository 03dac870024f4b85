% SHAPESTUDY  What a form.csv makes of the surrogates of few runs.
%
% CALL: octave-cli benchmarks/shapeStudy.m STANDINS SEEDS MORE CSV
%
%   STANDINS  names of storedStandIn, separated by commas;  SEEDS  e.g. 1:8
%   MORE      runs beyond the number of parameters, e.g. [3, 8]
%   CSV       table, to which one row a response, a way and a plan is added
%
% Latin hypercubes of runs of the stand-in, whose responses are fitted as a calibration
% does it, with the scatter of 8 packings known: without form.csv (known), with it
% (bench), with a wrong one (other, half: storedShape). The covariance is matern52, to
% save time. One row: standin, way, seed, runs, target, miss (root mean square over the
% box, in tolerances), density (log density of the mean response, of a tolerance),
% inside (share within the 90 % interval), believed (the known shape was taken), seconds
% of processor.
%
% See also: storedShape, floors

1;

function study (name, seeds, more, file)
  ways = {'known', 'bench', 'other', 'half'};
  [done, counted] = startTable (file, ['standin,way,seed,runs,target,miss,density,', ...
                                       'inside,believed,seconds'], 4);
  shapes = [];
  for seed = seeds
    S = storedStandIn (name, seed);
    for n = numel (S.names) + more
      if any (strcmp (done, sprintf ('%s,half,%d,%d', name, seed, n)))
        continue
      end
      if isempty (shapes)
        right = storedShape (S, '');
        shapes = {cell(1, numel (S.value)), right, storedShape(S, 'other', right), ...
                  storedShape(S, 'half', right)};
      end
      plan = planOf (S, 100 * seed + n, n);
      for w = 1:4
        addRowsOf (file, {name, ways{w}, seed, n}, S, plan, shapes{w});
      end
    end
  end
end

function plan = planOf (S, seed, n)
  rand ('twister', seed);
  randn ('twister', seed);
  d = numel (S.names);
  U = double (stk_sampling_randomlhs (n, d, [zeros(1, d); ones(1, d)]));
  plan.X = fromUnit (U, S.limits);
  Z = S.response (plan.X);
  plan.Z = Z .* (1 + S.noise .* randn (size (Z)));
  plan.P = [sampleBox(100, S.limits); S.truth];
  plan.truth = S.response (plan.P);
  runs = 1 + S.noise .* randn (8, numel (S.value));
  plan.sd = abs (S.value) .* std (runs) ./ mean (runs);
end

function addRowsOf (file, place, S, plan, shape)
  for t = 1:numel (S.value)
    started = cputime ();
    s = fitSurrogate (plan.X, plan.Z(:, t), S.limits, ...
                      struct ('scatter', [plan.sd(t), 8], 'quick', true, ...
                              'covariance', 'matern52', 'shape', shape{t}));
    seconds = cputime () - started;
    s.solver.open = parameterSpread (s);
    [m, v] = predictSurrogate (s, plan.P);
    tol = S.tol(t) * abs (S.value(t));
    off = plan.truth(:, t) - m;
    density = studentLogDensity (off ./ sqrt (v), s.df) - 0.5 * log (v / tol^2);
    inside = abs (off) < studentQuantile (0.95, s.df) * sqrt (v);
    appendLine (file, rowText ([place, {S.targetNames{t}, sqrt(mean (off.^2)) / tol, ...
                                        mean(density), mean(inside), ...
                                        ~ischar(s.trend), seconds}]));
  end
end

function d = studentLogDensity (u, df)
  d = gammaln ((df + 1) / 2) - gammaln (df / 2) - 0.5 * log (df * pi) - ...
      (df + 1) / 2 * log1p (u.^2 / df);
end

addpath (fileparts (mfilename ('fullpath')));
startBenchmarks ();
pkg ('load', 'stk');
pkg ('load', '-nodeps', 'struct', 'optim');
given = argv ();
for name = strsplit (given{1}, ',')
  study (name{1}, str2num (given{2}), str2num (given{3}), given{4});
end

% SPDX-License-Identifier: GPL-3.0-only
