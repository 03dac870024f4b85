% FITEFFECT  Learns what effects add to one response, zero at neutral.
%
% CALL: FIT = fitEffect (POWERS, Q, R, NOISE, BASE, GRID)
%
%   POWERS  q x c, monomials; the strength in each of them
%   Q       n x c, runs: parameters in [-1, 1], then bent strengths
%   R       n x 2, result minus the mean of the surrogates without the effect,
%           and the strength (of a pair: the product of both)
%   NOISE   scalar or n x 1, variance of each R of its own
%   BASE    n x 1, variance of the baseline surrogate there (0): its error is
%           alike in all runs; a plane through the box carries seven tenths of
%           it, the rest is independent. A second column: the variance of what
%           the level of the run does to the effect, alike in the same way
%   GRID    struct decay (1 x a), misfit (1 x b): FIT has only a score then, of
%           these values (without them: values of its own, and all of FIT); size
%           (scalar, what s below may be: the mean square that the effect adds
%           to responses like this one; without it: not known)
%   FIT     struct: coef (q x 1), covariance (q x q, of the coefficients),
%           misfit (variance per strength squared that no polynomial makes),
%           score (log of the mean marginal likelihood), looStd (n x 1,
%           standardised leave-one-out residuals at the likeliest values)
%
% Kriging with a polynomial covariance: R = B coef + misfit + noise,
%   coef ~ N (0, s diag (g .^ (degree - 1))), misfit ~ N (0, m strength^2).
% Every monomial holds the strength, so the effect is exactly zero at neutral
% and the null model stays nested in the model with the effect. What the
% polynomial cannot follow is part of the prediction's variance, not of the
% noise. Mean and covariance are averages over s, g and m with their marginal
% likelihoods: few runs do not tell these values, and the likeliest ones alone
% often say that an effect is exactly nothing. One run alone would leave s open
% to all that is larger: log s is normal around that of SIZE, deviation 2, which
% counts less the more runs there are; g and m have the prior g^-2 (1 + m)^-3:
% an effect is much the same all over the box. Few runs do not tell that, runs
% of LIGGGHTS do (closed study markScore.m, benchmarks/README.md). A singular
% value decomposition makes each trial cheap (Rasmussen and Williams 2006, 2.7,
% 5.4).
%
% Errors: DEcalioc:fitEffect:badShape

function fit = fitEffect (powers, Q, r, noise, base, grid)
  if rows (Q) ~= rows (r) || columns (r) ~= 2
    error ('DEcalioc:fitEffect:badShape', ...
           ['fitEffect: Q and R (two columns) must have equal numbers of ' ...
            'rows, got %d and %d x %d.'], rows (Q), size (r));
  end
  if nargin < 5
    base = 0;
  end
  if nargin < 6
    grid = struct ();
  end
  onlyScore = isfield (grid, 'decay');
  if ~onlyScore
    [grid.decay, grid.misfit] = deal ([0.03, 0.1, 0.3, 1], [0, 1, 4, 16, 64]);
  end
  % else the error of the baseline, alike in all runs, would be learned as the effect
  noise = covarianceOfRuns (Q, noise, base .* ones (rows (r), 1), ...
                            sign (r(:, 2)));
  % in squares of the strength, as the misfit is; relative to the largest
  strength2 = max (r(:, 2).^2, 1e-16 * max (r(:, 2).^2));
  unit = mean (diag (noise)) / mean (strength2);
  B = polyRows (powers, Q);
  % each order beyond the lowest is less likely by the factor g: smooth marks first
  degree = sum (powers, 2)' - min (sum (powers, 2));
  % from a sixteenth of the noise, where an effect is not seen, to 4^9 times it,
  % where the prior no longer pulls
  scales = mean (diag (noise)) * 4.^(-2:9)';
  likely = zeros (size (scales));
  if isfield (grid, 'size')
    % normal in the logarithm, deviation 2
    likely = -log (scales / grid.size).^2 / 8;
  end
  trials = [];
  for m = grid.misfit
    L = chol (noise + m * unit * diag (strength2), 'lower');
    % determinant of the noise, and the prior of the misfit
    penalty = sum (log (diag (L))) + 3 * log1p (m);
    for g = grid.decay
      trial = tryScales (L \ B, L \ r(:, 1), sqrt (g.^degree), scales);
      trial.score = trial.score - penalty - 2 * log (g) + likely;
      trial.L = L;
      trial.misfit = m * unit;
      trials = [trials, trial];
    end
  end
  scores = [trials.score];
  % mean over all trials: few runs do not tell one of them from the others
  fit.score = max (scores(:)) + log (mean (exp (scores - max (scores(:)))(:)));
  if ~onlyScore
    fit = average (fit, trials, scales, B, r(:, 1));
  end
end

function C = covarianceOfRuns (Q, noise, base, way)
  p = columns (Q) - 1;
  root = sqrt (base);
  root(:, 2:end) = root(:, 2:end) .* way;
  plane = [ones(rows (Q), 1), Q(:, 1:p)];
  % a square has the mean 1 / 3 in [-1, 1]: 0.4 + 0.9 / 3 = 0.7 in the mean
  shared = (plane .* [0.4, 0.9 / p * ones(1, p)]) * plane';
  C = (root * root') .* shared + diag (noise + 0.3 * sum (base, 2));
end

% Log marginal likelihood of every scale of the coefficients.
function trial = tryScales (B, y, weight, scales)
  % along the axes of B each scale costs a sum instead of an inverse
  [U, S, V] = svd (B .* weight, 'econ');
  s = diag (S)';
  part = (U' * y)';
  rest = max (y' * y - sum (part.^2), 0);
  spread = 1 + scales * s.^2;
  trial.score = -0.5 * (sum (log (spread) + part.^2 ./ spread, 2) + rest);
  trial.half = V .* weight';
  trial.weight = weight;
  trial.s = s;
  trial.part = part;
end

function fit = average (fit, trials, scales, B, r)
  scores = [trials.score];
  w = exp (scores - max (scores(:)));
  % what is a hundredth as likely as the best one only costs time
  w(w < 0.01) = 0;
  w = w / sum (w(:));
  fit.coef = zeros (columns (B), 1);
  second = zeros (columns (B));
  fit.misfit = 0;
  for k = find (any (w, 1))
    % all scales of one trial at once
    one = trials(k);
    i = find (w(:, k));
    [own, c] = deal (w(i, k), scales(i));
    spread = 1 + c * one.s.^2;
    coefs = one.half * (c .* one.s .* one.part ./ spread)';
    shrunk = (own .* c.^2)' * (one.s.^2 ./ spread);
    fit.coef = fit.coef + coefs * own;
    second = second + (own' * c) * diag (one.weight.^2) - ...
             (one.half .* shrunk) * one.half' + (coefs .* own') * coefs';
    fit.misfit = fit.misfit + sum (own) * one.misfit;
  end
  % law of total variance: within the trials, and between their means
  fit.covariance = second - fit.coef * fit.coef';
  [~, best] = max (w(:));
  [i, j] = ind2sub (size (w), best);
  fit.looStd = leaveOut (trials(j), scales(i), B, r);
end

function z = leaveOut (trial, scale, B, r)
  B = B .* trial.weight;
  % all runs left out, each once, from one inverse (Dubrule 1983, J. Math. Geol.
  % 15; Rasmussen and Williams 2006, 5.4.2)
  inverse = inv (trial.L * trial.L' + scale * (B * B'));
  z = (inverse * r) ./ sqrt (diag (inverse));
end

%!test
%! % a noiseless product is learned; neutral gives zero by construction
%! rand ('twister', 1); randn ('twister', 1);
%! powers = polyPowers (2, 3);
%! powers = powers(powers(:, 2) > 0, :);
%! Q = [2 * rand(25, 1) - 1, rand(25, 1)];
%! r = [2 * Q(:, 2) + Q(:, 1) .* Q(:, 2), Q(:, 2)];
%! fit = fitEffect (powers, Q, r, 1e-6 * ones (25, 1));
%! assert (polyRows (powers, [0.5, 1]) * fit.coef, 2.5, 0.01);
%! assert (polyRows (powers, [0.5, 0]) * fit.coef, 0);
%!test
%! % pure noise: the strength stays within four of its own deviations (seeded)
%! rand ('twister', 1); randn ('twister', 1);
%! Q = [2 * rand(30, 1) - 1, rand(30, 1)];
%! fit = fitEffect ([0, 1; 1, 1], Q, [randn(30, 1), Q(:, 2)], ones (30, 1));
%! b = polyRows ([0, 1; 1, 1], [0, 1]);
%! assert (abs (b * fit.coef) < 4 * sqrt (b * fit.covariance * b') + 0.1);
%!test
%! % a kink that no quadratic follows is kept as misfit (seeded)
%! rand ('twister', 2); randn ('twister', 2);
%! powers = [0, 1; 1, 1; 0, 2];
%! Q = [2 * rand(40, 1) - 1, rand(40, 1)];
%! kink = 5 * Q(:, 2) .* (rand (40, 1) > 0.5);
%! noise = 0.01 * ones (40, 1);
%! fit = fitEffect (powers, Q, [kink, Q(:, 2)], noise);
%! assert (fit.misfit > 1 && fit.misfit < 30);
%! straight = fitEffect (powers, Q, [2 * Q(:, 2) + 0.1 * randn(40, 1), ...
%!                                   Q(:, 2)], noise);
%! assert (straight.misfit < 0.1);
%! % what looks like nothing stays uncertain
%! assert (straight.covariance(1) > 1e-6);
%!error id=DEcalioc:fitEffect:badShape
%! fitEffect ([0, 1], [0, 1], [1, 1; 2, 1], [1; 1])
%!test
%! % an error that the baseline makes alike in all runs is no effect: left to it
%! % the signature would be 1, not 0
%! Q = [linspace(-1, 1, 20)', 0.1 + 0.9 * mod(7 * (1:20)', 20) / 20];
%! r = [ones(20, 1), Q(:, 2)];
%! told = fitEffect ([0, 1; 1, 1], Q, r, 0.01, ones (20, 1));
%! left = fitEffect ([0, 1; 1, 1], Q, r, 0.01 + 0.3);
%! assert (told.coef(1) < 0.7 * left.coef(1));

% SPDX-License-Identifier: GPL-3.0-only
