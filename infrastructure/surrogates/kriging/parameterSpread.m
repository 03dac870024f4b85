% PARAMETERSPREAD  What the parameters of a Kriging model leave open.
%
% CALL: OPEN = parameterSpread (SURROGATE)
%
% OPEN       struct: root (k x k, of the covariance of the k parameters: log
%            variance, log inverse ranges, log noise), runs (n x k, the change
%            with each column of root of what the covariance of the runs makes of
%            solver.alpha); [] where nothing is open: a response that no run has
%            moved, more than 150 runs
%
% After d + 3 runs other parameters are almost as likely as those of the fit,
% under which the mean is another one, most of all where no run is near. Their
% covariance is the inverse of the second derivatives of fitCost (Laplace), nowhere
% wider than their prior; krigingPosterior adds what it makes of the mean to what
% is open. With k and K the covariances of a set with the runs and of the runs, and
% lambda the weights of stk_predict, the mean changes by (dk' - lambda' dK) alpha.

function open = parameterSpread (surrogate)
  s = surrogate.solver;
  open = [];
  n = numel (s.y);
  if isConstant (surrogate.z) || n > 150
    return
  end
  [of, slopes] = noiseTerms (surrogate);
  model = krigingModel (surrogate.trend, surrogate.covariance, ...
                        columns (s.unit), of);
  open.root = spreadAt (surrogate.theta, model, s);
  open.runs = [covarianceSlopes(surrogate, s.unit), slopes] * open.root;
end

% OF for krigingModel, and what the noise terms times alpha change with the
% parameters of the noise.
function [of, slopes] = noiseTerms (surrogate)
  noise = exp (surrogate.model.lognoisevariance(:));
  alpha = surrogate.solver.alpha;
  of = mergeFields (surrogate, struct ('noise', []));
  slopes = [];
  if ~isempty (surrogate.noiseLaw)
    slopes = noise .* alpha .* [ones(size (alpha)), surrogate.extra];
  elseif isscalar (noise)
    slopes = noise * alpha;
  else
    of.noise = noise;
  end
end

function root = spreadAt (theta, model, s)
  k = numel (theta);
  h = 1e-3;
  H = zeros (k);
  [~, g] = fitCost (model, s.unit, s.y, theta);
  for j = 1:k
    [~, ahead] = fitCost (model, s.unit, s.y, theta + h * ((1:k)' == j));
    H(:, j) = (ahead - g) / h;
  end
  sd = model.prior.sd;
  if isfield (model, 'noiseprior')
    sd(end + 1) = model.noiseprior.sd;
  end
  H = sd .* (H + H') / 2 .* sd';
  [Q, D] = eig (H);
  root = sd .* Q ./ sqrt (max (diag (D), 1))';
end

%!shared X, z, s
%! rand ('twister', 3);
%! randn ('twister', 3);
%! X = rand (9, 2);
%! z = 3 + X(:, 1) + sqrt (X(:, 2)) + 0.02 * randn (9, 1);
%! s = fitSurrogate (X, z, [0, 0; 1, 1]);

%!test
%! % the mean changes as that of a model with other parameters
%! o = s;
%! o.solver.open = parameterSpread (s);
%! P = [0.2, 0.9; X(3, :); 0.9, 0.1; 0.6, 0.4; 0, 1];
%! [~, ~, S] = krigingPosterior (o, P);
%! [~, ~, sure] = krigingPosterior (s, P);
%! base = struct ('name', '', 'X', X, 'z', s.solver.y, ...
%!                'limits', s.limits, 'shift', 0, 'scale', 1, 'quick', false, 'published', false);
%! choice = struct ('trend', s.trend, 'covariance', s.covariance);
%! for j = 1:4
%!   for side = 1:2
%!     at = s.theta + (2 * side - 3) * 1e-4 * o.solver.open.root(:, j);
%!     choice.param = at(1:3);
%!     choice.lognoisevariance = at(4);
%!     m(:, side) = predictSurrogate (conditionSurrogate (choice, base), P);
%!   end
%!   change(:, j) = diff (m, 1, 2) / 2e-4;
%! end
%! assert (S - sure, change * change', 1e-5 * max (diag (S - sure)));

%!test
%! % never wider than the prior; more away from the runs; nothing of a constant
%! open = parameterSpread (s);
%! sd = [2; 1; 1; 1.6];
%! assert (sumsq (open.root, 2) <= sd.^2 * (1 + 1e-9));
%! [~, before] = predictSurrogate (s, [0.5, 0.5; 1, 0]);
%! o = s;
%! o.solver.open = open;
%! [~, v] = predictSurrogate (o, [0.5, 0.5; 1, 0]);
%! assert (all (v > before));
%! assert (diff (v - before) > 0);
%! flat = fitSurrogate (X, 7 * ones (9, 1), [0, 0; 1, 1]);
%! assert (isempty (parameterSpread (flat)));

%!test
%! % a further input and known noises have parameters of their own
%! rootOf = @(options) parameterSpread ( ...
%!                       fitSurrogate (X, z, [0, 0; 1, 1], options)).root;
%! extra = [zeros(5, 1); ones(4, 1)];
%! assert (size (rootOf (struct ('extra', extra))), [6, 6]);
%! assert (size (rootOf (struct ('noise', 4e-4 * ones (9, 1)))), [3, 3]);

%!test
%! % responses drawn from the prior: 82 in 100 of the 90 % intervals hold the
%! % mean response (less than 40 of 60 in 0.3 %), more than without the spread
%! rand ('twister', 7);
%! randn ('twister', 7);
%! inside = zeros (60, 2);
%! of = struct ('noise', [], 'extra', [], 'prior', [], 'scatter', [], ...
%!              'scale', 1, 'quick', false, 'published', false);
%! prior = krigingModel ('affine', 'matern52', 2, of);
%! mean = [prior.prior.mean; prior.noiseprior.mean];
%! sd = [prior.prior.sd; prior.noiseprior.sd];
%! for i = 1:60
%!   X = rand (9, 2);
%!   model = stk_set_optimizable_parameters (prior, mean + sd .* randn (4, 1));
%!   theta = [model.param; model.lognoisevariance];
%!   model.lognoisevariance = theta(1) - 23;
%!   K = stk_make_matcov (model, X);
%!   f = chol (K, 'lower') * randn (9, 1) + X * [2; -2];
%!   z = f + exp (theta(4) / 2) * randn (9, 1);
%!   s = fitSurrogate (X(1:8, :), z(1:8), [0, 0; 1, 1], ...
%!                     struct ('trend', 'affine', 'covariance', 'matern52'));
%!   for k = 1:2
%!     [m, v] = predictSurrogate (s, X(9, :));
%!     half = studentQuantile (0.95, s.df) * sqrt (v);
%!     inside(i, k) = abs (m - f(9)) < half;
%!     s.solver.open = parameterSpread (s);
%!   end
%! end
%! assert (all (inside(:, 2) >= inside(:, 1)));
%! assert (sum (inside(:, 2)) >= 40);

% SPDX-License-Identifier: GPL-3.0-only
