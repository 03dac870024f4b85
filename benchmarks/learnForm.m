% LEARNFORM  Trend, ranges, bends and noise of a stand-in, from thousands of runs.
%
% CALL: FORM = learnForm (S [, NPLAN])
%
%   S      struct of standIn;  NPLAN  Latin hypercubes of 2 (d + 3) noisy runs to
%          fit, and as many to choose (100)
%   FORM   1 x T struct array for problem.form, see fitSurrogate; score (log
%          density of a left-out run, in the mean)
%
% What a calibration estimates from its few runs: the restricted likelihood of
% fitCost, here summed over all plans, so that the parameters are those that
% are best for plans of the size that a calibration has; its prior counts once.
% Trend (constant, affine), kernel and bends of the inputs are those that foretell
% left-out runs of the second half of the plans best. The noise is the law of the
% stand-in.
%
% See also: floors, fitSurrogates

function form = learnForm (S, nPlan)
  if nargin < 2
    nPlan = 50;
  end
  rand ('twister', 5);
  randn ('twister', 5);
  d = numel (S.names);
  for k = 1:2 * nPlan
    X = double (stk_sampling_randomlhs (2 * (d + 3), d, S.limits(1:2, :)));
    Z = S.response (X);
    plans(k) = struct ('X', X, 'Z', Z .* (1 + S.noise .* randn (size (Z))));
  end
  noise = S.noise .* ones (1, numel (S.value));
  for t = 1:numel (S.value)
    form(t) = bestForm (plans, t, S.limits(1:2, :), noise(t));
  end
end

function best = bestForm (plans, t, limits, noise)
  z = vertcat (plans.Z)(:, t);
  d = columns (limits);
  start = struct ('trend', 'affine', 'covariance', 'matern52', 'limits', ...
                  [limits; zeros(2, d)], 'shift', mean (z), ...
                  'scale', std (z), 'param', [], 'score', -Inf, ...
                  'noise', @(y) (noise * y).^2);
  best = start;
  for trend = {'affine', 'constant'}
    for kernel = {'matern52', 'gauss'}
      new = mergeFields (start, struct ('trend', trend{1}, ...
                                        'covariance', kernel{1}));
      best = better (best, new, plans, t);
    end
  end
  for j = 1:d
    for bend = [-3, 3]
      new = best;
      new.limits(4, j) = bend;
      best = better (best, new, plans, t);
    end
  end
end

function best = better (best, new, plans, t)
  half = numel (plans) / 2;
  for k = 1:half
    fits(k) = fitOf (new, plans(k), t);
  end
  theta = new.param;
  if isempty (theta)
    theta = fits(1).model.param;
  end
  settings = optimset ('GradObj', 'on', 'TolFun', 1e-4, 'TolX', 1e-2, ...
                       'MaxIter', 30);
  new.param = fminunc (@(theta) together (theta, fits), theta, settings);
  new.score = 0;
  for k = half + 1:2 * half
    base = baseOf (new, plans(k), t);
    new.lognoisevariance = log (base.noise);
    s = conditionSurrogate (new, base);
    new.score = new.score + s.score / (half * numel (base.y));
  end
  new = rmfield (new, 'lognoisevariance');
  if new.score > best.score + 1e-3
    best = new;
  end
end

function base = baseOf (form, plan, t)
  z = plan.Z(:, t);
  base = struct ('name', '', 'X', plan.X, 'z', z, 'limits', form.limits, ...
                 'unit', toUnit (plan.X, form.limits), ...
                 'y', (z - form.shift) / form.scale, 'shift', form.shift, ...
                 'scale', form.scale, 'noise', form.noise (z) / form.scale^2);
end

function fit = fitOf (form, plan, t)
  base = baseOf (form, plan, t);
  of = mergeFields (base, struct ('extra', [], 'prior', [], 'scatter', [], ...
                                  'quick', true, 'published', false));
  fit = struct ('U', base.unit, 'y', base.y);
  fit.model = krigingModel (form.trend, form.covariance, ...
                            columns (base.unit), of);
end

% Each cost holds the prior: all but one of them are taken off.
function [C, g] = together (theta, fits)
  prior = fits(1).model.prior;
  u = (theta - prior.mean) ./ prior.sd;
  many = numel (fits) - 1;
  C = -0.5 * many * (u' * u);
  g = -many * u ./ prior.sd;
  for fit = fits
    [own, slope] = fitCost (fit.model, fit.U, fit.y, theta);
    C = C + own;
    g = g + slope;
  end
end

%!test
%! % a linear response in noise: nothing beyond the trend, and the law's noise
%! pkg load stk
%! S = struct ('names', {{'a', 'b'}}, 'limits', [0, 0; 1, 2], 'noise', 0.01, ...
%!             'value', 2, 'response', @(P) 1 + P(:, 1) + 0.1 * P(:, 2));
%! form = learnForm (S, 10);
%! assert (form.trend, 'affine');
%! assert (exp (form.param(1) / 2) * form.scale < 0.05);
%! assert (form.noise (3), 9e-4, 1e-12);

% SPDX-License-Identifier: GPL-3.0-only
