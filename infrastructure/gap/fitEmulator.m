% FITEMULATOR  Makes fast polynomials of Kriging models and candidate effects.
%
% CALL: EM = fitEmulator (PROBLEM, DATA, OPTIONS)
% CALL: EM = fitEmulator (PROBLEM, DATA, OPTIONS, OLD)
%
%   PROBLEM  struct of newGapProblem
%   DATA     struct X (n x p), E (n x v), Z (n x T, NaN = none), replicate
%   OPTIONS  struct of gapOptions
%   OLD      EM of fewer runs: its baseline is kept if no neutral run is new
%   EM       struct
%     p, powers (q x p), coef (q x T): mean of the null model, polynomial of the
%       baseline Kriging in parameters scaled to [-1, 1]
%     points (M x p), surrogateVar (M x T): where and how well it is known
%     varPowers (r x p): quadratic that the logarithm of variances follows
%     effect (1 x K): powers, coef (q x T; phi in each term), points, looStd
%       (cell), varOverPhi2 (M x T), varPowers, range, scale, name, runs,
%       laboratory
%     seedVar, seedDf, fitVar (error of the polynomial), looMean, looMax, Q2,
%       range (all 1 x T), correlation (T x T, of errors within a bench)
%     surrogates (1 x T struct of fitSurrogate), baseRuns (scalar)
%
% The baseline Kriging uses every run with all effects neutral, and serves
% every effect: only the difference an effect makes is learned from its runs.
%
% Errors: DEcalioc:fitEmulator:badValue
%
% See also: fitEffect, whitenEmulator, predictGap

function em = fitEmulator (problem, data, options, old)
  p = columns (problem.limits);
  data = inOrder (data);
  phi = effectStrength (problem.effects, data.E);
  theta = scaled (data.X, problem.limits);
  isBase = all (abs (phi) < 1e-9, 2);
  if sum (isBase) < p + 3
    error ('DEcalioc:fitEmulator:badValue', ...
           ['fitEmulator: DATA must hold at least %d runs with all effects ' ...
            'neutral, got %d. Run or import the plan first.'], p + 3, ...
           sum (isBase));
  end
  if nargin > 3 && old.baseRuns == sum (isBase)
    em = old;
  else
    em = baseline (problem, data, isBase, options);
  end
  [em.seedVar, em.seedDf, residual] = seedNoise ([data.X, data.E], data.Z);
  nugget = max ([em.surrogates.noiseVar], eps);
  weight = em.seedDf ./ (em.seedDf + 5);
  measured = em.seedVar;
  measured(em.seedDf == 0) = 0;
  em.seedVar = weight .* measured + (1 - weight) .* nugget;
  known = isfinite (problem.seedSd);
  em.seedVar(known) = problem.seedSd(known).^2;
  em.correlation = errorCorrelation (em, residual, problem.bench);
  em.effect = repmat (emptyEffect (), 1, 0);
  for k = 1:numel (problem.effects)
    own = abs (phi(:, k)) >= 1e-9 & sum (abs (phi) >= 1e-9, 2) == 1;
    em.effect(k) = oneEffect (em, problem.effects(k), ...
                              [theta(own, :), phi(own, k)], data.Z(own, :));
  end
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

function em = baseline (problem, data, isBase, options)
  p = columns (problem.limits);
  T = columns (data.Z);
  settings = struct ('covariance', options.covariance, ...
                     'trend', options.trend);
  for t = T:-1:1
    settings.name = problem.targetNames{t};
    fits(t) = fitSurrogate (data.X(isBase, :), data.Z(isBase, t), ...
                            problem.limits, settings);
  end
  em = struct ('p', p, 'surrogates', fits, 'baseRuns', sum (isBase));
  em.Q2 = [fits.Q2];
  em.looMean = arrayfun (@(s) mean (s.looStd.^2), fits);
  em.looMax = arrayfun (@(s) max (abs (s.looStd)), fits);
  em.range = rangesOf (problem, data.Z, isBase);
  em.points = boxPoints (p, max (200, 4 * rows (polyPowers (p, 4))));
  X = problem.limits(1, :) + (em.points + 1) / 2 .* diff (problem.limits);
  [average, em.surrogateVar] = predictSurrogate (fits, X);
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
function range = rangesOf (problem, Z, isBase)
  span = @(A) max (A, [], 1) - min (A, [], 1);
  range = span (Z(isBase, :));
  for t = find (range <= 100 * eps (max (abs (Z), [], 1)))
    range(t) = max ([span([Z(:, t); problem.y(t)]), problem.sd(t), eps]);
  end
end

% The corners matter for a polynomial: a third of the points is drawn outwards.
function points = boxPoints (d, n)
  primes_ = primes (60);
  points = zeros (n, d);
  for j = 1:d
    points(:, j) = 2 * vanDerCorput (n, primes_(j)) - 1;
  end
  outer = 1:3:n;
  points(outer, :) = sin (pi / 2 * points(outer, :));
end

function x = vanDerCorput (n, base)
  x = zeros (n, 1);
  left = (1:n)' + 20;
  scale = 1 / base;
  while any (left > 0)
    x = x + scale * mod (left, base);
    left = floor (left / base);
    scale = scale / base;
  end
end

function [coef, errorVar] = leastSquares (points, values, powers)
  B = polyRows (powers, points);
  coef = B \ values;
  n = rows (B);
  errorVar = sum ((values - B * coef).^2) / max (n - columns (B), 1);
end

function C = errorCorrelation (em, residual, bench)
  T = numel (bench);
  lengths = arrayfun (@(s) numel (s.looStd), em.surrogates);
  R = zeros (0, T);
  if all (lengths == lengths(1))
    R = [em.surrogates.looStd];
  end
  residual = residual(all (isfinite (residual), 2), :);
  R = [R; residual ./ sqrt(em.seedVar)];
  R = R(all (isfinite (R), 2), :);
  n = rows (R);
  scale = sqrt (sum (R.^2));
  C = (R' * R) ./ max (scale' * scale, eps) * n / (n + 2 * T);
  C(bench' ~= bench) = 0;
  C(1:T + 1:end) = 1;
end

function e = emptyEffect ()
  e = struct ('name', '', 'powers', [], 'coef', [], 'points', [], ...
              'varOverPhi2', [], 'looStd', {{}}, 'varPowers', [], ...
              'range', [], 'scale', [], 'runs', 0, 'laboratory', false);
end

function e = oneEffect (em, effect, Q, Z)
  T = columns (em.coef);
  e = emptyEffect ();
  e.name = effect.name;
  e.range = effect.range;
  e.scale = effect.scale;
  e.laboratory = effect.laboratory;
  e.runs = sum (any (isfinite (Z), 2));
  e.varPowers = polyPowers (em.p + 1, 2);
  e.points = boxPoints (em.p + 1, 6 * rows (e.varPowers));
  e.points(:, end) = e.range(1) + (e.points(:, end) + 1) / 2 * diff (e.range);
  if effect.laboratory
    e.powers = [em.powers, ones(rows (em.powers), 1)];
    e.coef = em.coef * effect.matrix;
    e.coef(1, :) = e.coef(1, :) + effect.offset;
    e.varOverPhi2 = zeros (rows (e.points), T);
    return
  end
  e.powers = polyPowers (em.p + 1, 3);
  e.powers = e.powers(e.powers(:, end) > 0, :);
  e.coef = zeros (rows (e.powers), T);
  B = polyRows (e.powers, e.points) ./ e.points(:, end);
  for t = 1:T
    fit = oneResponse (em, t, e.powers, Q, Z(:, t));
    e.coef(:, t) = fit.coef;
    e.looStd{t} = fit.looStd;
    e.varOverPhi2(:, t) = max (sum ((B * fit.covariance) .* B, 2), eps);
  end
end

function fit = oneResponse (em, t, powers, Q, z)
  ok = isfinite (z);
  Q = Q(ok, :);
  limits = em.surrogates(t).limits;
  X = limits(1, :) + (Q(:, 1:end - 1) + 1) / 2 .* diff (limits);
  if isempty (Q)
    q = rows (powers);
    first = sum (powers, 2) == 1;
    fit = struct ('coef', zeros (q, 1), 'looStd', zeros (0, 1), ...
                  'covariance', em.range(t)^2 * diag (first));
    return
  end
  [m, v] = predictSurrogate (em.surrogates(t), X);
  fit = fitEffect (powers, Q, z(ok) - m, em.seedVar(t) + v);
end

%!test
%! % means of the emulator agree with the laboratory within its own variances
%! % (mean of 24 x 50 squared errors over variances: 4 deviations allowed)
%! rand ('twister', 1); randn ('twister', 1);
%! lab = standInGap (0);
%! problem = newGapProblem (setfield (lab.problem, 'y', ones (1, 24)));
%! data = lab.plan (30, 10);
%! em = fitEmulator (problem, data, gapOptions (struct ('trend', 'affine')));
%! theta = rand (50, 4);
%! phi = [zeros(50, 2), rand(50, 1), zeros(50, 7)];
%! white = whitenEmulator (em, 1:24, diag (lab.seedSd .^ 2));
%! [M, V] = predictGap (white, 3, [2 * theta - 1, phi(:, 3)]);
%! Z = lab.means (theta, phi) + lab.seedSd .* randn (50, 24);
%! ratio = mean (mean ((Z * white.W' - M) .^ 2 ./ V));
%! assert (ratio > 0.6 && ratio < 1.6);
%! assert (em.effect(9).laboratory && em.effect(9).runs == 0);
%!test
%! % a response that only an effect moves has the range of that
%! lab = standInGap (0);
%! problem = newGapProblem (setfield (lab.problem, 'y', 8 * ones (1, 24)));
%! data = lab.plan (30, 10);
%! off = all (data.E == 0, 2);
%! data.Z(:, 2) = 5 * ~off;
%! em = fitEmulator (problem, data, gapOptions (struct ('trend', 'affine')));
%! assert (em.range(2), 8);
%! z = data.Z(off, 1);
%! assert (em.range(1), max (z) - min (z));
%!error id=DEcalioc:fitEmulator:badValue
%! lab = standInGap (0);
%! problem = newGapProblem (setfield (lab.problem, 'y', ones (1, 24)));
%! fitEmulator (problem, lab.plan (4, 2), ...
%!              gapOptions (struct ('trend', 'affine')));
