% FITEMULATOR  Makes fast polynomials of Kriging models and candidate effects.
%
% CALL: EMULATOR = fitEmulator (PROBLEM, DATA, OPTIONS)
% CALL: EMULATOR = fitEmulator (PROBLEM, DATA, OPTIONS, OLD)
%
%   PROBLEM     struct of newProblem
%   DATA        struct X (n x p), E (n x v), Z (n x T, NaN = none), replicate;
%               level (n x T, how coarse each run is, see unitLevel: 0 at the
%               level that counts, which is that of all where it is missing)
%   OPTIONS     struct of gapOptions
%   OLD         EMULATOR of other runs: what its runs have in common with DATA is kept
%   EMULATOR    struct
%     p, limits, powers (q x p), coef (q x T): mean of the null model,
%       polynomial of the baseline Kriging in parameters scaled to [-1, 1]
%     points (M x p), surrogateVar (M x T): where and how well it is known
%     varPowers (r x p): quadratic that the logarithm of variances follows
%     effect (1 x K)  see learnEffect;  joint (1 x J)  see learnJoint
%     noiseVar, noiseFreedom (variance of one run and degrees of freedom of that
%       estimate, pooledNoise), fitVar (error of the polynomial), looMean,
%       looMax, Q2, range (all 1 x T), correlation (T x T, of errors within a
%       bench)
%     surrogates (1 x T struct of fitSurrogate), base (struct X, theta (X in
%       [-1, 1]), Z, level: its runs)
%     success, effect.success   where a bench gives a result (learnSuccess)
%     levelShare  share of an effect that changes between the first and the last
%       level, a standard deviation (levelShare)
%
% The emulator is a polynomial of the mean of the Kriging models: the integrals
% need it; what it misses (fitVar) and their own variance go along.
%
% The baseline Kriging uses every run with all effects neutral, and serves
% every effect: only the difference an effect makes is learned from its runs,
% and what two do together from runs with both. Coarse runs tell of the last
% level: the baseline as far as one Kriging over parameters and level says
% (fitLevels), an effect less what may change with the level (learnEffect).
%
% Errors: DEcalioc:fitEmulator:badValue

function emulator = fitEmulator (problem, data, options, old)
  p = columns (problem.limits);
  data = inOrder (data);
  phi = strengthOfValues (problem.effects, data.E);
  theta = 2 * toUnit (data.X, problem.limits) - 1;
  isBase = all (abs (phi) < 1e-9, 2);
  % p + 1 coefficients of a plane, and two runs more that tell how wrong it is
  if sum (isBase) < p + 3
    error ('DEcalioc:fitEmulator:badValue', ...
           ['fitEmulator: DATA must hold at least %d runs with all effects ' ...
            'neutral, got %d. Run or import the plan first.'], p + 3, ...
           sum (isBase));
  end
  base = struct ('X', data.X(isBase, :), 'Z', data.Z(isBase, :), ...
                 'theta', theta(isBase, :), 'level', data.level(isBase, :));
  if nargin < 4
    old = struct ('base', [], 'effect', [], 'noiseRuns', -1);
  end
  emulator = old;
  if ~isequaln (old.base, base)
    start = [];
    if isOneRunOff (old, base)
      start = old.surrogates;
    end
    emulator = fitBaseline (emulator, problem, data, isBase, options, start);
    emulator.base = base;
  end
  runs = struct ('theta', theta, 'phi', phi, 'Z', data.Z, ...
                 'level', data.level);
  [runs.mean, runs.variance] = atOwnLevel (emulator.surrogates, data);
  others = sum (~isBase);
  if ~isOneRunOff (old, base) || abs (others - old.noiseRuns) > 0.25 * others
    % the noise follows from the effects' runs, and they from the noise
    emulator = runNoise (emulator, problem, data);
    alone = sum (abs (phi) >= 1e-9, 2) == 1;
    emulator.levelShare = 0;
    if any (data.level(:))
      isCoarse = any (data.level, 2);
      coarse = learnAll (emulator, problem.effects, runsOf (runs, isCoarse), ...
                         1:columns (phi), []);
      emulator.levelShare = levelShare (emulator, coarse, runsOf (runs, ~isCoarse));
    end
    % the polynomial of an effect takes up what fewer than six runs scatter
    many = find (sum (abs (phi(alone, :)) >= 1e-9, 1) >= 6);
    some = learnAll (emulator, problem.effects(many), runsOf (runs, alone), ...
                     many, []);
    [emulator.noiseVar, emulator.noiseFreedom] = pooledNoise (emulator, some);
    emulator.noiseRuns = others;
    old.effect = [];
  end
  emulator.effect = learnAll (emulator, problem.effects, runs, 1:columns (phi), ...
                              old.effect);
  emulator.joint = learnJoint (emulator, runs);
  [emulator.success, own] = learnSuccess (problem.bench, theta, phi, data.Z);
  for k = 1:numel (own)
    emulator.effect(k).success = own{k};
  end
  emulator.bench = problem.bench;
  [emulator.change, emulator.known] = deal ([]);
end

% One run more or less changes neither the noise nor the other effects.
function yes = isOneRunOff (old, base)
  yes = ~isempty (old.base) && abs (rows (old.base.X) - rows (base.X)) <= 2;
end

function runs = runsOf (runs, at)
  for name = fieldnames (runs)'
    runs.(name{1}) = runs.(name{1})(at, :);
  end
end

% Candidates, whose strengths are the columns NUMBERS. What has the same runs as
% before is kept.
function effects = learnAll (emulator, candidates, runs, numbers, old)
  effects = [];
  isOn = abs (runs.phi) >= 1e-9;
  alone = sum (isOn(:, numbers), 2) == 1;
  for k = 1:numel (candidates)
    own = runsOf (runs, isOn(:, numbers(k)) & alone);
    own.phi = own.phi(:, numbers(k));
    known = [];
    if ~isempty (old)
      known = find (strcmp ({old.name}, candidates(k).name));
    end
    if ~isempty (known) && isequaln (old(known).Q, [own.theta, own.phi]) && ...
       isequaln (old(known).Z, own.Z) && isequal (old(known).level, own.level)
      effects = [effects, old(known)];
    else
      effects = [effects, learnEffect(emulator, candidates(k), own)];
    end
  end
  if isempty (effects)
    effects = repmat (struct ('name', '', 'range', [], 'runs', 0, ...
                              'laboratory', false), 1, 0);
  end
end

% The same runs in another order give other last digits, and then other sets to
% verify: a second start finds its runs in the order in which they ended.
function data = inOrder (data)
  if ~isfield (data, 'level')
    data.level = zeros (size (data.Z));
  end
  [~, order] = sortrows ([data.X, data.E, data.replicate]);
  data = struct ('X', data.X(order, :), 'E', data.E(order, :), ...
                 'Z', data.Z(order, :), 'level', data.level(order, :));
end

% What the model without effects gives where and as coarse as the runs are; NaN
% where the surrogate holds no runs of that level.
function [m, v] = atOwnLevel (surrogates, data)
  [m, v] = predictSurrogate (surrogates, data.X);
  for t = find (any (data.level, 1))
    level = data.level(:, t);
    s = surrogates(t);
    coarse = level ~= 0;
    [m(coarse, t), v(coarse, t)] = deal (NaN);
    if ~isempty (s.extra)
      known = coarse & ~ismember (level, s.dropped);
      [m(known, t), v(known, t)] = ...
        predictSurrogate (s, [data.X(known, :), level(known)]);
    end
  end
end

% Logistic regression of success (NaN: none, NA: not run) on 1 and parameters
% (BASE; zeros where no run of the bench has failed), and |phi| and phi of each
% effect (OWN): where the measurement went through, strengths at which the model
% jams are unlikely. Maximum posterior with coefficients N (0, 3^2), the
% intercept free, by Newton's method. Strengths count threefold, so that within
% its range an effect may lead from sure to impossible.
function [base, own] = learnSuccess (bench, theta, phi, Z)
  p = columns (theta);
  K = columns (phi);
  F = [ones(rows (theta), 1), theta, 3 * abs(phi), 3 * phi];
  B = max (bench);
  coef = zeros (columns (F), B);
  for b = 1:B
    own = Z(:, bench == b);
    isRun = ~any (isna (own), 2);
    none = all (isnan (own), 2) & isRun;
    if any (none) && any (isRun & ~none)
      coef(:, b) = logistic (F(isRun, :), ~none(isRun));
    end
  end
  base = coef(1:p + 1, :);
  own = cell (1, K);
  for k = 1:K
    own{k} = 3 * coef(p + 1 + [k, K + k], :);
  end
end

function coef = logistic (F, yes)
  precision = [1e-4; ones(columns (F) - 1, 1)] / 9;
  share = mean (yes);
  coef = [log(share / (1 - share)); zeros(columns (F) - 1, 1)];
  for step = 1:50
    p = 1 ./ (1 + exp (-F * coef));
    g = F' * (yes - p) - precision .* coef;
    % where all outcomes are sure the curvature vanishes, and a step would have no
    % bound
    H = F' * (max (p .* (1 - p), 1e-6) .* F) + diag (precision);
    move = H \ g;
    % Newton's full step overshoots where the curve is flat
    move = move / max (1, norm (move) / 4);
    coef = coef + move;
    if norm (move) < 1e-6
      return
    end
  end
end

%!test
%! % means of the emulator agree with the laboratory within its own variances
%! % (mean of 24 x 50 squared errors over variances: 4 deviations allowed)
%! rand ('twister', 1); randn ('twister', 1);
%! lab = standInGap (0);
%! lab.problem.value = ones (1, 24);
%! emulator = fitEmulator (newProblem (lab.problem), lab.plan (30, 10), ...
%!                   gapOptions (struct ('trend', 'affine')));
%! theta = rand (50, 4);
%! phi = [zeros(50, 2), rand(50, 1), zeros(50, 7)];
%! budget = struct ('covariance', diag (lab.noiseSd .^ 2), ...
%!                  'doubt', zeros (2, 24), 'estimated', zeros (1, 24), ...
%!                  'unknown', zeros (1, 24));
%! white = whitenEmulator (emulator, 1:24, budget);
%! [M, V] = predictGap (white, 3, [2 * theta - 1, phi(:, 3)]);
%! Z = lab.means (theta, phi) + lab.noiseSd .* randn (50, 24);
%! ratio = mean (mean ((Z * white.W' - M) .^ 2 ./ V));
%! assert (ratio > 0.6 && ratio < 1.6);
%! assert (emulator.effect(9).laboratory && emulator.effect(9).runs == 0);
%!error id=DEcalioc:fitEmulator:badValue
%! lab = standInGap (0);
%! lab.problem.value = ones (1, 24);
%! fitEmulator (newProblem (lab.problem), lab.plan (4, 2), struct ());
%!test
%! % a bench jams where the effect is strong, never without (seeded)
%! rand ('twister', 1);
%! X = rand (60, 1);
%! E = [zeros(30, 1); rand(30, 1)];
%! Z = [X + E, X + 0.1 * rand(60, 1)];
%! Z(E > 0.6, 2) = NaN;
%! effect = struct ('name', 'e', 'variables', {{'e'}}, 'neutral', 0, ...
%!                  'limits', [0; 1]);
%! given = struct ('value', [1, 1], 'sd', [1, 1], 'limits', [0; 1], ...
%!                 'bench', [1, 2], 'effects', effect);
%! data = struct ('X', X, 'E', E, 'Z', Z, 'replicate', 1 + 0 * X);
%! emulator = fitEmulator (newProblem (given), data, gapOptions ([]));
%! assert (emulator.success(:, 1), [0; 0]);
%! p = @(phi) 1 / (1 + exp (-emulator.success(1, 2) - ...
%!                          [phi, phi] * emulator.effect.success(:, 2)));
%! assert ([p(0), p(0.1)] > [0.95, 0.9]);
%! assert (p(1) < 0.2);

% SPDX-License-Identifier: GPL-3.0-only
