% FITEMULATOR  Makes fast polynomials of Kriging models and candidate effects.
%
% CALL: EM = fitEmulator (GAPPROBLEM, DATA, OPTIONS)
% CALL: EM = fitEmulator (GAPPROBLEM, DATA, OPTIONS, OLD)
%
%   GAPPROBLEM  struct of newGapProblem
%   DATA        struct X (n x p), E (n x v), Z (n x T, NaN = none), replicate
%   OPTIONS     struct of gapOptions
%   OLD         EM of other runs: what its runs have in common with DATA is kept
%   EM          struct
%     p, limits, powers (q x p), coef (q x T): mean of the null model,
%       polynomial of the baseline Kriging in parameters scaled to [-1, 1]
%     points (M x p), surrogateVar (M x T): where and how well it is known
%     varPowers (r x p): quadratic that the logarithm of variances follows
%     effect (1 x K)  see learnEffect;  joint (1 x J)  see learnJoint
%     noiseVar, noiseFreedom (variance of one run and degrees of freedom of that
%       estimate, pooledNoise), fitVar (error of the polynomial), looMean,
%       looMax, Q2, range (all 1 x T), correlation (T x T, of errors within a
%       bench)
%     surrogates (1 x T struct of fitSurrogate), base (struct X, Z: its runs)
%     success, effect.success   of learnSuccess: where a bench gives a result
%
% The emulator is a polynomial of the mean of the Kriging models: the integrals
% need it; what it misses (fitVar) and their own variance go along.
%
% The baseline Kriging uses every run with all effects neutral, and serves
% every effect: only the difference an effect makes is learned from its runs,
% and what two do together from runs with both.
%
% Errors: DEcalioc:fitEmulator:badValue
%
% See also: learnEffect, learnJoint, whitenEmulator, predictGap

function em = fitEmulator (gapProblem, data, options, old)
  p = columns (gapProblem.limits);
  data = inOrder (data);
  phi = strengthOfValues (gapProblem.effects, data.E);
  theta = scaled (data.X, gapProblem.limits);
  isBase = all (abs (phi) < 1e-9, 2);
  if sum (isBase) < p + 3
    error ('DEcalioc:fitEmulator:badValue', ...
           ['fitEmulator: DATA must hold at least %d runs with all effects ' ...
            'neutral, got %d. Run or import the plan first.'], p + 3, ...
           sum (isBase));
  end
  base = struct ('X', data.X(isBase, :), 'Z', data.Z(isBase, :));
  if nargin < 4
    old = struct ('base', [], 'effect', [], 'noiseRuns', -1);
  end
  em = old;
  if ~isequaln (old.base, base)
    em = baseline (gapProblem, data, isBase, options, old);
    em.base = base;
  end
  others = sum (~isBase);
  if ~isOneRunOff (old, base) || abs (others - old.noiseRuns) > 0.1 * others
    % the noise follows from the effects' runs, and they from the noise
    em = noiseOfRuns (em, gapProblem, data);
    alone = sum (abs (phi) >= 1e-9, 2) == 1;
    many = find (sum (abs (phi(alone, :)) >= 1e-9, 1) >= 6);
    some = learnAll (em, gapProblem.effects(many), theta(alone, :), ...
                     phi(alone, many), data.Z(alone, :), []);
    [em.noiseVar, em.noiseFreedom] = pooledNoise (em, some);
    em.noiseRuns = others;
    old.effect = [];
  end
  em.effect = learnAll (em, gapProblem.effects, theta, phi, data.Z, old.effect);
  em.joint = jointEffects (em, theta, phi, data.Z);
  [em.success, own] = learnSuccess (gapProblem.bench, theta, phi, data.Z);
  for k = 1:numel (own)
    em.effect(k).success = own{k};
  end
  em.bench = gapProblem.bench;
end

% One run more or less changes neither the noise nor the other effects.
function yes = isOneRunOff (old, base)
  yes = ~isempty (old.base) && abs (rows (old.base.X) - rows (base.X)) <= 2;
end

% What has the same runs as before is kept.
function effects = learnAll (em, candidates, theta, phi, Z, old)
  effects = [];
  for k = 1:numel (candidates)
    own = abs (phi(:, k)) >= 1e-9 & sum (abs (phi) >= 1e-9, 2) == 1;
    Q = [theta(own, :), phi(own, k)];
    known = [];
    if ~isempty (old)
      known = find (strcmp ({old.name}, candidates(k).name));
    end
    if ~isempty (known) && isequaln (old(known).Q, Q) && ...
       isequaln (old(known).Z, Z(own, :))
      effects = [effects, old(known)];
    else
      effects = [effects, learnEffect(em, candidates(k), Q, Z(own, :))];
    end
  end
  if isempty (effects)
    effects = repmat (struct ('name', '', 'range', [], 'runs', 0, ...
                              'laboratory', false), 1, 0);
  end
end

function joint = jointEffects (em, theta, phi, Z)
  joint = [];
  simulated = find (~[em.effect.laboratory] & [em.effect.runs] > 0);
  if numel (simulated) < 2
    return
  end
  for pair = nchoosek (simulated, 2)'
    both = all (abs (phi(:, pair)) >= 1e-9, 2) & ...
           sum (abs (phi) >= 1e-9, 2) == 2;
    joint = [joint, learnJoint(em, pair', [theta(both, :), phi(both, pair)], ...
                               Z(both, :))];
  end
end

% Runs that were repeated tell the scatter of one run; where they are few, the
% nugget of the Kriging model does.
function em = noiseOfRuns (em, gapProblem, data)
  [measured, df, residual] = replicateNoise ([data.X, data.E], data.Z);
  nugget = max ([em.surrogates.noiseVar], (1e-8 * em.range).^2);
  weight = df ./ (df + 5);
  measured(df == 0) = 0;
  em.noiseVar = weight .* measured + (1 - weight) .* nugget;
  em.noiseFreedom = df + [em.surrogates.df];
  known = isfinite (gapProblem.noiseSd);
  em.noiseVar(known) = gapProblem.noiseSd(known).^2;
  em.noiseFreedom(known) = Inf;
  residual = residual(all (isfinite (residual), 2), :);
  R = [looRows(em.surrogates); residual ./ sqrt(em.noiseVar)];
  R = R(all (isfinite (R), 2), :);
  [em.correlation, em.alongCurve] = errorCorrelation (R, gapProblem);
end

% The same runs in another order give other last digits, and then other sets to
% verify: a second start finds its runs in the order in which they ended.
function data = inOrder (data)
  [~, order] = sortrows ([data.X, data.E, data.replicate]);
  data = struct ('X', data.X(order, :), 'E', data.E(order, :), ...
                 'Z', data.Z(order, :));
end

function theta = scaled (X, limits)
  theta = 2 * (X - limits(1, :)) ./ (limits(2, :) - limits(1, :)) - 1;
end

function em = baseline (gapProblem, data, isBase, options, old)
  p = columns (gapProblem.limits);
  T = columns (data.Z);
  settings = struct ('covariance', options.covariance, ...
                     'trend', options.trend);
  em = old;
  em.range = rangesOf (gapProblem, data.Z, isBase);
  for t = T:-1:1
    settings.name = gapProblem.targetNames{t};
    settings.unit = em.range(t);
    if isOneRunOff (old, struct ('X', data.X(isBase, :)))
      settings.start = old.surrogates(t);
    end
    fits(t) = fitSurrogate (data.X(isBase, :), data.Z(isBase, t), ...
                            gapProblem.limits, settings);
  end
  em.p = p;
  em.limits = gapProblem.limits;
  em.surrogates = fits;
  em.Q2 = [fits.Q2];
  em.looMean = arrayfun (@(s) mean (s.looStd.^2), fits);
  em.looMax = arrayfun (@(s) max (abs (s.looStd)), fits);
  em.points = boxPoints (p, max (200, 4 * rows (polyPowers (p, 4))));
  [average, em.surrogateVar] = predictBaseline (em, em.points);
  noise = [fits.noiseVar] + mean (em.surrogateVar);
  for degree = 2:4
    em.powers = polyPowers (p, degree);
    [em.coef, em.fitVar] = leastSquares (em.points, average, em.powers);
    if rows (em.powers) * 4 > rows (em.points) || ...
          all (em.fitVar < 0.02 * noise)
      break
    end
  end
  em.varPowers = polyPowers (p, 2);
end

% What the parameters move; of a response that they do not move, what effects or
% the measurement do.
function range = rangesOf (gapProblem, Z, isBase)
  span = @(A) max (A, [], 1) - min (A, [], 1);
  range = span (Z(isBase, :));
  for t = find (range <= 100 * eps (max (abs (Z), [], 1)))
    range(t) = max (span ([Z(:, t); gapProblem.value(t)]), gapProblem.sd(t));
    if ~(range(t) > 0)
      range(t) = gapProblem.unit(t);
    end
  end
end

function [coef, errorVar] = leastSquares (points, values, powers)
  B = polyRows (powers, points);
  coef = B \ values;
  n = rows (B);
  errorVar = sum ((values - B * coef).^2) / max (n - columns (B), 1);
end

% Leave-one-out residuals, where all targets have the same runs.
function R = looRows (surrogates)
  lengths = arrayfun (@(s) numel (s.looStd), surrogates);
  R = zeros (0, numel (surrogates));
  if all (lengths == lengths(1))
    R = [surrogates.looStd];
  end
end

%!test
%! % means of the emulator agree with the laboratory within its own variances
%! % (mean of 24 x 50 squared errors over variances: 4 deviations allowed)
%! rand ('twister', 1); randn ('twister', 1);
%! lab = standInGap (0);
%! given = setfield (lab.gapProblem, 'value', ones (1, 24));
%! gapProblem = newGapProblem (given);
%! data = lab.plan (30, 10);
%! em = fitEmulator (gapProblem, data, gapOptions (struct ('trend', 'affine')));
%! theta = rand (50, 4);
%! phi = [zeros(50, 2), rand(50, 1), zeros(50, 7)];
%! budget = struct ('covariance', diag (lab.noiseSd .^ 2), ...
%!                  'estimated', zeros (1, 24), ...
%!                  'unknown', zeros (1, 24));
%! white = whitenEmulator (em, 1:24, budget);
%! [M, V] = predictGap (white, 3, [2 * theta - 1, phi(:, 3)]);
%! Z = lab.means (theta, phi) + lab.noiseSd .* randn (50, 24);
%! ratio = mean (mean ((Z * white.W' - M) .^ 2 ./ V));
%! assert (ratio > 0.6 && ratio < 1.6);
%! assert (em.effect(9).laboratory && em.effect(9).runs == 0);
%!test
%! % a response that only an effect moves has the range of that
%! lab = standInGap (0);
%! given = setfield (lab.gapProblem, 'value', 8 * ones (1, 24));
%! gapProblem = newGapProblem (given);
%! data = lab.plan (30, 10);
%! off = all (data.E == 0, 2);
%! data.Z(:, 2) = 5 * ~off;
%! em = fitEmulator (gapProblem, data, gapOptions (struct ('trend', 'affine')));
%! assert (em.range(2), 8);
%! z = data.Z(off, 1);
%! assert (em.range(1), max (z) - min (z));
%!error id=DEcalioc:fitEmulator:badValue
%! lab = standInGap (0);
%! given = setfield (lab.gapProblem, 'value', ones (1, 24));
%! gapProblem = newGapProblem (given);
%! fitEmulator (gapProblem, lab.plan (4, 2), ...
%!              gapOptions (struct ('trend', 'affine')));
