% PARAMETERPOSTERIOR  What the targets say about the parameters.
%
% CALL: KNOWN = parameterPosterior (SURROGATES, PROBLEM)
% CALL: KNOWN = parameterPosterior (SURROGATES, PROBLEM, NSAMPLE)
%
% SURROGATES  1 x T struct array of fitSurrogates
% PROBLEM     struct of newProblem; seed of the sampler: options.seed
% NSAMPLE     size of the sample (1000; 400 for many targets and runs)
% KNOWN       struct: names 1 x d, mean, sd 1 x d, interval90 2 x d (5 and 95 %
%             quantiles), correlation d x d, sample NSAMPLE x d, shrink 1 x d
%             (sd over that of the flat prior), identified 1 x d logical (the
%             interval is narrower than half of the box)
%
% Flat prior on the box, times a normal one for parameters that were measured
% by themselves (PROBLEM.paramMean, paramSd). Each calibrated target is Student
% distributed about the surrogate mean with the variance of the surrogate there,
% plus the scatter of one run (the experiment is one packing, or the mean of
% PROBLEM.trials), plus the uncertainty of the measurement. The points of a
% curve are one observation with a covariance, see curveErrors; where the length
% of their errors or their size is not known, it is sampled together with the
% parameters. Sampled by tempering: particles of the prior are reweighted,
% resampled and moved by Metropolis steps until the full likelihood is reached
% (Del Moral, Doucet and Jasra 2006).

function known = parameterPosterior (surrogates, problem, nSample)
  if nargin < 3
    nSample = 1000 - 600 * isLarge (surrogates);
  end
  restore = seedRandom (problem.options.seed);
  d = columns (problem.limits);
  [curves, nFree] = curveErrors (surrogates, problem);
  U = rand (nSample, d + nFree);
  fit = logLikelihood (surrogates, problem, U, curves);
  nMoves = 8 - 4 * isLarge (surrogates);
  heat = 0;
  while heat < 1
    [heat, weight] = nextHeat (heat, fit);
    U = U(resample (weight), :);
    fit = logLikelihood (surrogates, problem, U, curves);
    [U, fit] = moveParticles (U, fit, heat, nMoves, @(V) ...
                              logLikelihood (surrogates, problem, V, curves));
  end
  known = summarise (U(:, 1:d), problem);
end

function yes = isLarge (surrogates)
  % a prediction costs the square of the runs for each target
  yes = sum (arrayfun (@(s) numel (s.z)^2, surrogates)) > 5e5;
end

function fit = logLikelihood (surrogates, problem, U, curves)
  d = columns (problem.limits);
  P = problem.limits(1, :) + U(:, 1:d) .* diff (problem.limits);
  [m, v] = predictSurrogate (surrogates, P);
  z = (P - problem.paramMean) ./ problem.paramSd;
  fit = -0.5 * sumsq (z(:, isfinite (problem.paramSd)), 2);
  for t = find (problem.calibrate & problem.curve == 0)
    s = surrogates(t);
    total = v(:, t) + errorVariance (s.noiseVar, problem, t);
    z2 = (problem.value(t) - m(:, t)).^2 ./ total;
    fit = fit - 0.5 * log (total) - (s.df + 1) / 2 * log1p (z2 / s.df);
  end
  for c = curves
    fit = fit + curveLikelihood (c, m(:, c.points), v(:, c.points), ...
                                 U(:, d + c.free));
  end
end

function [heat, weight] = nextHeat (heat, fit)
  % the largest step that keeps half of the particles effective
  n = numel (fit);
  low = 0;
  high = 1 - heat;
  weight = weights (fit, high);
  if 1 / sum (weight.^2) >= n / 2
    heat = 1;
    return
  end
  for i = 1:30
    step = (low + high) / 2;
    weight = weights (fit, step);
    if 1 / sum (weight.^2) >= n / 2
      low = step;
    else
      high = step;
    end
  end
  heat = heat + step;
end

function weight = weights (fit, step)
  weight = exp (step * (fit - max (fit)));
  weight = weight / sum (weight);
end

function rowsKept = resample (w)
  n = numel (w);
  edges = [0; cumsum(w)];
  edges(end) = 1 + eps (1);
  rowsKept = lookup (edges, ((0:n - 1)' + rand ()) / n);
end

function [U, fit] = moveParticles (U, fit, heat, nMoves, likelihood)
  [n, d] = size (U);
  S = cov (U) + 1e-8 * full (eye (d));
  root = chol (S);
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
  width = diff (problem.limits);
  P = problem.limits(1, :) + U .* width;
  known.names = problem.names;
  known.mean = mean (P, 1);
  known.sd = std (P, 0, 1);
  known.interval90 = quantile (P, [0.05; 0.95], 1, 7);
  known.correlation = corr (U);
  known.sample = P;
  known.shrink = known.sd ./ (width / sqrt (12));
  known.identified = diff (known.interval90, 1, 1) < ...
                     problem.options.loose * width;
end

% Variance of a measured value about the mean response: the packing of the
% trials that were averaged, and the uncertainty of the measurement; where that
% comes from the scatter of the trials it holds their packings already, and the
% larger counts.
function v = errorVariance (noiseVar, problem, t)
  packing = noiseVar / problem.trials(t);
  if problem.scatter(t)
    v = max (packing, problem.sd(t)^2);
  else
    v = packing + problem.sd(t)^2;
  end
end

%!test
%! % linear response: the interval equals the one of the formula
%! pkg load stk
%! rand ('twister', 1);
%! randn ('twister', 1);
%! C = struct ('names', {{'a', 'b'}}, 'limits', [0, 0; 1, 1], ...
%!             'targets', struct ('value', 2, 'tol', 0.01, 'sd', 0.1));
%! X = rand (15, 2);
%! z = 1 + 2 * X(:, 1) + 0.02 * randn (15, 1);
%! s = fitSurrogate (X, z, C.limits);
%! before = rand ('twister');
%! known = parameterPosterior (s, newProblem (C, []));
%! assert (rand ('twister'), before);
%! assert (known.mean(1), 0.5, 0.03);
%! assert (known.sd(1), 0.05, 0.015);
%! assert (known.identified, [true, false]);
%! assert (known.shrink(2), 1, 0.15);
%! assert (size (known.correlation), [2, 2]);
%! % a parameter that the target leaves open is known where it was measured
%! % (mean of 1000 draws, their effective number a tenth: 0.05 / 10 times 4)
%! C.paramMean = [NaN, 0.3];
%! C.paramSd = [NaN, 0.05];
%! known = parameterPosterior (s, newProblem (C, []));
%! assert (known.mean, [0.5, 0.3], 0.03);
%! assert (known.sd, [0.05, 0.05], 0.015);

%!test
%! % the trials' packings and the uncertainty of their mean: 4 trials of scatter
%! % 0.04 and sd 0.03 are as sure as one of 0.036; as sd from scatter, as 0.03
%! pkg load stk
%! rand ('twister', 1);
%! randn ('twister', 1);
%! C = struct ('names', {{'a'}}, 'limits', [0; 1], ...
%!             'targets', struct ('value', 1.5, 'tol', 0.01, 'sd', 0.03));
%! X = rand (40, 1);
%! s = fitSurrogate (X, 1 + X + 0.04 * randn (40, 1), C.limits);
%! problem = newProblem (C, []);
%! sd = zeros (1, 3);
%! for k = 1:3
%!   problem.trials = [1, 4, 4](k);
%!   problem.scatter = k == 3;
%!   sd(k) = parameterPosterior (s, problem).sd;
%! end
%! assert (sd, [0.05, 0.036, 0.03], 0.009);
%! assert (sd(1) > sd(2) && sd(2) > sd(3));
