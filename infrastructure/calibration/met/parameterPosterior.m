% PARAMETERPOSTERIOR  What the targets say about the parameters.
%
% CALL: KNOWN = parameterPosterior (SURROGATES, PROBLEM [, NSAMPLE])
%
% PROBLEM     struct of newProblem; seed of the sampler: options.seed
% NSAMPLE     size of the sample (1000; 400 for many targets and runs)
% KNOWN       struct: interval90 2 x d (5 and 95 % quantiles), correlation d x
%             d, sample NSAMPLE x d
%
% Flat prior on the box, on its allowed sets alone, times a normal one for
% parameters that were measured by themselves (PROBLEM.paramMean, paramSd). Each
% calibrated target is Student distributed about the surrogate mean with the
% variance of the surrogate there, plus the scatter of one run (the experiment
% is one packing, or the mean of PROBLEM.trials), plus the uncertainty of the
% measurement. The points of a curve are one observation with a covariance, see
% jointErrors; where the length of their errors or their size is not known, it
% is sampled together with the parameters. The targets of a bench, read from one
% packing, have one density (benchLikeness). Sampled by tempering: particles of
% the prior are reweighted, resampled and moved by Metropolis steps until the
% full likelihood is reached (Del Moral, Doucet and Jasra 2006).

function known = parameterPosterior (surrogates, problem, nSample)
  % a prediction costs the square of the runs for each target
  isLarge = sum (arrayfun (@(s) numel (s.z)^2, surrogates)) > 5e5;
  if nargin < 3
    nSample = 1000 - 600 * isLarge;
  end
  restore = seedRandom (problem.options.seed);
  d = columns (problem.limits);
  [joint, nFree, alone] = jointErrors (surrogates, problem);
  % many to begin with: a small part of the box may be all that fits
  nFirst = nSample * max (1, min (20, floor (1e6 / ...
                                             sumsq ([surrogates.nChoice]))));
  U = allowedRows (rand (nFirst, d + nFree), problem);
  [~, P] = setsAt (U, problem);
  [~, v] = predictSurrogate (surrogates, P(1:min (end, 200), :));
  likeness = benchLikeness (surrogates, problem, joint, alone, mean (v, 1));
  likelihood = @(U) logLikelihood (surrogates, problem, U, joint, likeness);
  fit = likelihood (U);
  heat = 0;
  while heat < 1
    [heat, weight] = nextHeat (heat, fit, nSample);
    U = U(resample (weight, nSample), :);
    [U, fit] = moveParticles (U, likelihood (U), heat, 8 - 4 * isLarge, ...
                              likelihood);
  end
  known = summarise (U(:, 1:d), problem);
end

function fit = logLikelihood (surrogates, problem, U, joint, likeness)
  d = columns (problem.limits);
  [isIn, P] = setsAt (U, problem);
  [m, v] = predictSurrogate (surrogates, P);
  z = (P - problem.paramMean) ./ problem.paramSd;
  fit = -0.5 * sumsq (z(:, isfinite (problem.paramSd)), 2);
  level = zeros (rows (m), numel (joint));
  for i = 1:numel (joint)
    c = joint(i);
    [own, level(:, i)] = c.logLikelihood (m(:, c.points), v(:, c.points), ...
                                          U(:, d + c.free));
    fit = fit + own;
  end
  for one = likeness
    t = one.alone;
    total = v(:, t) + one.variance;
    fit = fit + benchDensity (problem.value(t) - m(:, t), total, level(:, one.curves), one);
  end
  fit(~isIn) = -Inf;
end

% The sets at places in the unit box, whose further columns are no parameters.
function [isIn, P] = setsAt (U, problem)
  limits = problem.limits;
  [isIn, P] = isAllowed (fromUnit (U(:, 1:columns (limits)), limits), problem);
end

% Places of the prior: those that are not allowed are drawn again; where they
% are a hundred times as many, the allowed ones stand for them.
function U = allowedRows (U, problem)
  d = columns (problem.limits);
  wrong = find (~setsAt (U, problem));
  for k = 1:100
    if isempty (wrong)
      return
    end
    U(wrong, :) = rand (numel (wrong), columns (U));
    wrong(setsAt (U(wrong, :), problem)) = [];
  end
  sample = toUnit (problem.allowed.sample, problem.limits);
  U(wrong, 1:d) = sample(1 + mod (0:numel (wrong) - 1, rows (sample)), :);
end

function [heat, weight] = nextHeat (heat, fit, nSample)
  % the largest step that keeps half of the particles effective
  range = [0, 1 - heat];
  [weight, isEven] = weights (fit, range(2), nSample);
  if isEven
    heat = 1;
    return
  end
  for i = 1:30
    step = sum (range) / 2;
    [weight, isEven] = weights (fit, step, nSample);
    range(2 - isEven) = step;
  end
  heat = heat + step;
end

function [weight, isEven] = weights (fit, step, nSample)
  weight = exp (step * (fit - max (fit)));
  weight = weight / sum (weight);
  isEven = 1 / sum (weight.^2) >= nSample / 2;
end

function rowsKept = resample (weight, n)
  edges = [0; cumsum(weight)];
  edges(end) = 1 + eps (1);
  rowsKept = lookup (edges, ((0:n - 1)' + rand ()) / n);
end

function [U, fit] = moveParticles (U, fit, heat, nMoves, likelihood)
  [n, d] = size (U);
  root = chol (cov (U) + 1e-8 * full (eye (d)));
  scale = 2.38 / sqrt (d);
  for k = 1:nMoves
    V = U + scale * randn (n, d) * root;
    inside = all (V >= 0 & V <= 1, 2);
    new = -Inf (n, 1);
    if any (inside)
      new(inside) = likelihood (V(inside, :));
    end
    accept = log (rand (n, 1)) < heat * (new - fit);
    U(accept, :) = V(accept, :);
    fit(accept) = new(accept);
    scale = scale * exp (mean (accept) - 0.25);
  end
end

function known = summarise (U, problem)
  [~, known.sample] = setsAt (U, problem);
  known.interval90 = quantile (known.sample, [0.05; 0.95], 1, 7);
  known.correlation = corr (U);
end

%!function [problem, s] = linear (names, X, z, sd)
%!  limits = [zeros(1, numel (names)); ones(1, numel (names))];
%!  C = struct ('names', {names}, 'limits', limits, ...
%!              'targets', struct ('value', 2, 'tol', 0.01, 'sd', sd));
%!  problem = newProblem (C, []);
%!  s = fitSurrogate (X, z, limits);
%!endfunction
%!shared X, noise
%! rand ('twister', 1);
%! randn ('twister', 1);
%! X = rand (40, 2);
%! noise = randn (40, 1);

%!test
%! % linear response: the interval equals the one of the formula
%! [problem, s] = linear ({'a', 'b'}, X(1:15, :), ...
%!                        1 + 2 * X(1:15, 1) + 0.02 * noise(1:15), 0.1);
%! before = rand ('twister');
%! known = parameterPosterior (s, problem);
%! assert (rand ('twister'), before);
%! assert (mean (known.sample(:, 1)), 0.5, 0.03);
%! assert (std (known.sample), [0.05, 1 / sqrt(12)], [0.015, 0.04]);
%! assert (diff (known.interval90) < 0.5, [true, false]);
%! assert (size (known.correlation), [2, 2]);
%! % a parameter that the target leaves open is known where it was measured
%! % (mean of 1000 draws, their effective number a tenth: 0.05 / 10 times 4)
%! problem.paramMean = [NaN, 0.3];
%! problem.paramSd = [NaN, 0.05];
%! sample = parameterPosterior (s, problem).sample;
%! assert (mean (sample), [0.5, 0.3], 0.03);
%! assert (std (sample), [0.05, 0.05], 0.015);

%!test
%! % the trials' packings and the uncertainty of their mean: 4 trials of scatter
%! % 0.04 and sd 0.03 are as sure as one of 0.036; as sd from scatter, as 0.03
%! [problem, s] = linear ({'a'}, X(:, 1), 1.5 + X(:, 1) + 0.04 * noise, 0.03);
%! for k = 1:3
%!   problem.trials = [1, 4, 4](k);
%!   problem.scatter = k == 3;
%!   sd(k) = std (parameterPosterior (s, problem).sample);
%! end
%! assert (sd, [0.05, 0.036, 0.03], 0.009);
%! assert (sd(1) > sd(2) && sd(2) > sd(3));

%!test
%! % five results of one packing (correlation 0.9) tell hardly more than one, those of
%! % five packings as sure as 5 (seeded; benchmarks/evidenceLab.m counts)
%! randn ('twister', 11);
%! U = ((1:20)' - 0.5) / 20;
%! slope = [1, 1.2, 0.9, 1.1, 1];
%! e = 0.1 * (sqrt (0.9) * randn (20, 1) + sqrt (0.1) * randn (20, 5));
%! C = struct ('names', {{'a'}}, 'limits', [-2; 3], 'targets', ...
%!             struct ('value', num2cell (3 + 0.5 * slope), 'tol', 0.02));
%! problem = newProblem (C, []);
%! data = addRows (newData (1, 5), U, 3 + U * slope + e, ones (20, 1), 'plan');
%! s = fitSurrogates (data, problem);
%! width = diff (parameterPosterior (s, problem).interval90);
%! for t = 1:5
%!   s(t).looStd = circshift (s(t).looStd, 4 * t);
%! end
%! assert (width / diff (parameterPosterior (s, problem).interval90) > 1.6);

% SPDX-License-Identifier: GPL-3.0-only
