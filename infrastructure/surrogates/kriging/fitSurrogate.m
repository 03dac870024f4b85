% FITSURROGATE  Kriging model of one response, noise estimated, choice checked.
%
% CALL: SURROGATE = fitSurrogate (X, Z, LIMITS [, OPTIONS])
%
% X        n x d  inputs; rows may repeat (replicates carry pure error)
% Z        n x 1  responses; rows with NaN are left out
% LIMITS   2 x d  box of the inputs
% OPTIONS  struct, every field optional:
%   name        char, name of the response ('')
%   trend       'constant', 'affine', 'quadratic' or 'choose' ('choose')
%   covariance  'matern32', 'matern52', 'gauss' or 'choose' ('choose'); a
%               published one may be any of krigingModel
%   start       surrogate of an earlier fit: its choice is kept, its
%               parameters are the start ([])
%   noise       n x 1 known variances of the single runs ([]: estimated)
%   unit        scalar, the size that counts: a response that is the same in all
%               runs is known to a millionth of it (NaN: of the response)
%   extra       n x 1, a further input that needs no box; predicted is where it
%               is 0, and the noise may change along it ([])
%   level       n x 1, how coarse each run is (unitLevel): of several see fitLevels
%   prior       (d + 2) x 1, see krigingModel; left for a gain above 1.5 ([])
%   scatter     1 x 2, see noisePrior; left as the prior is ([])
%   quick       logical, by quickCost instead of stk_param_relik (false)
%   guess       parameters (theta of a surrogate) that are near ([])
%   published   logical, without priors, from stk_param_init on (false)
%   shape       d x 2, slope and curvature along each input in the unit box, known of
%               the bench (trendOf): one more trend to choose from ([])
%   form        struct, what is known of the response beforehand and not
%               estimated: trend, covariance, param (of the stk model), limits
%               (with its bends), shift and scale (of the standardised
%               response), noise (handle, response -> variance of a run) ([])
%
% SURROGATE: name, model (of stk, in the unit box and the standardised
% response), X, z, extra, limits, noiseVar (of one run, where extra is 0), noiseLaw
% (see conditionSurrogate), looResidual and looStd (n x 1), Q2, trend,
% covariance, and what predictSurrogate needs: solver, shift, scale, factor, df,
% score (leave-one-out log density), nChoice (runs at the choice of the model),
% leftOut, suspect, aside ([], see fitSurrogates), dropped ([], see fitLevels),
% warning.
%
% Parameters: stk_param_estim (estimateModel). Choice: leave-one-out log
% predictive density, trend first, bends of the inputs (bendInputs, the fourth
% row of limits, see toUnit) last; an affine trend, matern52 and straight inputs
% are left only for a gain above 1.5: the best score is partly luck. Of more rows 150 estimate
% the parameters, and 60 while the model is chosen.
%
% Errors: DEcalioc:fitSurrogate:badShape, DEcalioc:fitSurrogate:runFailed

function surrogate = fitSurrogate (X, z, limits, options)
  if nargin < 4
    options = struct ();
  end
  if size (z, 1) ~= size (X, 1) || size (X, 2) ~= size (limits, 2)
    error ('DEcalioc:fitSurrogate:badShape', ...
           ['fitSurrogate: X must be n x d, z n x 1 and limits 2 x d, got ' ...
            '%d x %d, %d x %d and %d x %d.'], size (X), size (z), ...
           size (limits));
  end
  [level, options] = levelsOf (z, options);
  if ~isempty (level)
    surrogate = fitLevels (X, z, level, limits, options);
    return
  end
  options = mergeFields (struct ('name', '', 'trend', 'choose', ...
                                 'covariance', 'choose', 'start', [], ...
                                 'noise', [], 'extra', [], 'unit', NaN, ...
                                 'prior', [], 'scatter', [], ...
                                 'quick', false, 'published', false, 'guess', [], ...
                                 'shape', [], 'form', []), options);
  if ~isempty (options.form)
    limits = options.form.limits;
  elseif ~isempty (options.start)
    limits = options.start.limits;           % as it bends its inputs
  end
  ok = isfinite (z);
  options.extra = ofRows (options.extra, ok);
  if sum (ok) < 2
    error ('DEcalioc:fitSurrogate:runFailed', ...
           ['fitSurrogate: response ''%s'' has %d finite values, needs 2 ' ...
            'or more. Look at the failed runs.'], options.name, sum (ok));
  end
  base = standardise (X(ok, :), z(ok), limits, options);
  if ~isempty (options.form)
    surrogate = ofForm (base, options.form);
  elseif ~isempty (options.start)
    surrogate = refit (base, options.start);
  elseif isConstant (base.z)
    surrogate = conditionSurrogate (constantChoice (base), base);
  else
    surrogate = chooseModel (base, options);
  end
end

% [] where all results are of one level.
function [level, options] = levelsOf (z, options)
  level = [];
  if isfield (options, 'level')
    [level, options] = deal (options.level, rmfield (options, 'level'));
  end
  if ~isempty (level) && numel (unique (level(isfinite (z)))) < 2
    level = [];
  end
end

function base = standardise (X, z, limits, options)
  base = struct ('name', options.name, 'X', X, 'z', z, 'limits', limits, ...
                 'extra', options.extra, 'noiseLaw', [], ...
                 'prior', options.prior, 'scatter', options.scatter, ...
                 'quick', options.quick, 'published', options.published, ...
                 'guess', options.guess, ...
                 'maxFit', 150, ...
                 'shift', mean (z), 'scale', std (z));
  if isConstant (z)
    sizes = [options.unit, abs(base.shift), 1];
    base.scale = sizes(find (sizes > 0, 1));
  end
  base.knownNoise = options.noise / base.scale^2;
end

% Nothing is estimated, so nothing widens the prediction.
function surrogate = ofForm (base, form)
  base.shift = form.shift;
  base.scale = form.scale;
  form.lognoisevariance = log (form.noise (base.z) / form.scale^2);
  surrogate = conditionSurrogate (form, base);
  surrogate.factor = 1;
  surrogate.df = 1e6;
end

% A response that no run has moved is expected to stay where it is.
function choice = constantChoice (base)
  small = 2 * log (1e-6);
  choice = struct ('trend', 'constant', 'covariance', 'matern52', ...
                   'param', [small; zeros(inputsOf (base), 1)], ...
                   'lognoisevariance', small);
end

function surrogate = refit (base, old)
  choice = mergeFields (old, old.model);
  base.prior = old.prior;
  base.scatter = old.scatter;
  if ~isConstant (base.z)
    start = old.theta;
    nNoise = numel (start) - numel (old.model.param);
    if isConstant (old.z) || nNoise ~= 1 + ~isempty (base.extra)
      start = [];
    end
    [choice, base.noiseLaw] = estimate (old.trend, old.covariance, base, start);
  end
  surrogate = conditionSurrogate (choice, base);
  surrogate.nChoice = old.nChoice;
end

function best = chooseModel (base, options)
  few = base;                          % enough for the choice of the model
  few.maxFit = 60;
  use = spreadRows (rows (base.X), 200);
  for name = {'X', 'z', 'extra', 'knownNoise'}
    few.(name{1}) = ofRows (base.(name{1}), use);
  end
  [trends, covariances, default] = candidateModels (few, options);
  best = [];
  for i = [default, setdiff(1:numel (trends), default)]
    best = better (best, trends{i}, covariances{1}, few);
  end
  if ~isempty (options.shape) && isempty (base.extra)
    % left only for a gain above 1.5: of d + 3 runs the score is mostly luck
    best = better (best, options.shape, covariances{1}, few, -1.5);
  end
  for i = 2:numel (covariances)
    best = better (best, best.trend, covariances{i}, few);
  end
  [few.prior, few.scatter] = deal ([]);
  if ~isempty (best.prior) || ~isempty (best.scatter)
    best = better (best, best.trend, best.covariance, few);
  end
  if numel (covariances) > 1 && ischar (best.trend)
    best = withBends (best, few);
  end
  n = rows (base.X);
  if n > few.maxFit
    base.limits = best.limits;
    best = refit (base, best);
    best.nChoice = n;
  end
end

% Where the slope of the response changes much along an input, two bends of it
% are tried, too.
function best = withBends (best, few)
  for choice = bendInputs (best)
    few.limits = best.limits;
    few.limits(4, choice(1)) = choice(2);
    best = better (best, best.trend, best.covariance, few);
  end
end

function d = inputsOf (base)
  d = columns (base.X) + columns (base.extra);
end

function [trends, covariances, default] = candidateModels (base, options)
  [n, d] = deal (rows (base.X), inputsOf (base));
  trends = {options.trend};
  if strcmp (options.trend, 'choose')
    trends = {'constant', 'affine', 'quadratic'};
    enough = n >= [0, d + 4, 1.5 * (d + 1) * (d + 2)];
    % two values have a straight line between them, and no square
    enough(3) = enough(3) && ~(numel (unique (base.extra)) == 2);
    trends = trends(enough);
  end
  % where an input is the same in all runs, or follows from others, no trend along
  % it can be told
  unit = unitInputs ([base.X, base.extra], base.limits, columns (base.extra));
  isClear = @(t) rank (feval (trendOf (t), unit), 1e-9) >= ...
                 columns (feval (trendOf (t), unit(1, :)));
  trends = trends(cellfun (isClear, trends));
  if isempty (trends)
    trends = {'constant'};
  end
  covariances = {options.covariance};
  if strcmp (options.covariance, 'choose')
    covariances = {'matern52', 'matern32', 'gauss'};
  end
  default = min (2, numel (trends));
end

function use = spreadRows (n, most)
  use = unique (round (linspace (1, n, min (n, most))));
end

function best = better (best, trend, covariance, base, gain)
  if nargin < 5
    gain = 1.5;
  end
  start = base.guess;
  if ~isempty (best)
    start = best.theta;
  end
  [choice, base.noiseLaw] = estimate (trend, covariance, base, start);
  new = conditionSurrogate (choice, base);
  if isempty (best) || new.score > best.score + gain
    best = new;
  end
end

function [choice, noiseLaw] = estimate (trend, covariance, base, theta)
  d = inputsOf (base);
  use = spreadRows (rows (base.X), base.maxFit);
  unit = unitInputs ([base.X, base.extra], base.limits, columns (base.extra));
  y = (base.z - base.shift) / base.scale;
  of = mergeFields (base, struct ('extra', ofRows (base.extra, use), ...
                                  'noise', ofRows (base.knownNoise, use)));
  model = krigingModel (trend, covariance, d, of);
  if ~isempty (of.noise)
    theta(d + 2:end) = [];             % known noise is no parameter
  end
  if numel (theta) ~= numel (stk_get_optimizable_parameters (model))
    theta = [];                        % of another model
  end
  theta = estimateModel (model, unit(use, :), y(use), theta);
  choice = struct ('trend', trend, 'covariance', covariance, ...
                   'param', theta(1:numel (model.param)), ...
                   'lognoisevariance', log (base.knownNoise));
  noiseLaw = [];
  if isempty (of.noise) && ~isempty (of.extra)
    noiseLaw = theta(end - 1:end)';
    choice.param = theta(1:end - 2);
    choice.lognoisevariance = noiseLaw(1) + noiseLaw(2) * base.extra;
  elseif isempty (of.noise)
    choice.lognoisevariance = theta(end);
  end
end

function list = ofRows (list, rowsOf)
  if ~isempty (list)
    list = list(rowsOf, :);
  end
end

%!shared X, z, lim
%! rand ('twister', 2);
%! randn ('twister', 2);
%! lim = [0, 0, 0; 1, 1, 1];
%! X = rand (20, 3);
%! z = 5 + 3 * X(:, 1) - 2 * X(:, 2) + 0.1 * randn (20, 1);
%!test
%! % noise within a factor of 2 of the truth (chance of failing below 1 %)
%! s = fitSurrogate (X, z, lim);
%! assert (sqrt (s.noiseVar) > 0.05 && sqrt (s.noiseVar) < 0.2);
%! assert (s.Q2 > 0.9 && s.Q2 < 1 && numel (s.looResidual) == 20);
%!test
%! % rows with NaN are left out, choices can be fixed
%! y = setfield (z, {[3, 7]}, NaN);
%! fixed = struct ('trend', 'affine', 'covariance', 'matern32');
%! s = fitSurrogate (X, y, lim, fixed);
%! assert (size (s.X), [18, 3]);
%! assert ({s.trend, s.covariance}, {'affine', 'matern32'});
%!test
%! % an input that no run varied, and one that follows from another: no trend along
%! % it, and nothing is known far from the runs
%! lastwarn ('');
%! for still = {0.5 + 0 * X(:, 2), 0.2 + 0.5 * X(:, 1)}
%!   s = fitSurrogate ([X(:, 1), still{1}], 5 + 3 * X(:, 1), lim(:, 1:2));
%!   assert (s.trend, 'constant');
%!   assert (lastwarn (), '');
%!   [~, v] = predictSurrogate (s, [0.5, mean(still{1}); 0.5, 1]);
%!   assert (v(2) > 4 * v(1));
%! end
%!test
%! % a constant response is no error, and stays what it is
%! s = fitSurrogate (X, 7 * ones (20, 1), lim);
%! [m, v] = predictSurrogate (s, [0.5, 0.5, 0.5]);
%! assert ({m, v}, {7, 0}, 1e-8);
%! assert (s.warning, 'the response is constant');
%! small = fitSurrogate (X, zeros (20, 1), lim, struct ('unit', 1e-9));
%! assert (small.noiseVar, 1e-30, 1e-40);
%! s = fitSurrogate ([X; X], 7 * ones (40, 1), lim, struct ('start', s));
%! s = fitSurrogate ([X; X], [z; z], lim, struct ('start', s));
%! assert (s.Q2 > 0.9);
%!test
%! % a shape that is known of the bench: five runs of three parameters tell more with
%! % it, and a wrong one is not taken
%! truth = @(X) 7 + 4 * (X * [3; -2; 1] - X(:, 1).^2);
%! o = struct ('scatter', [0.1, 8], 'shape', [3, -1; -2, 0; 1, 0]);
%! few = X(1:6, :);
%! miss = @(s) sqrt (mean ((predictSurrogate (s, X) - truth (X)).^2));
%! s = fitSurrogate (few, truth (few), lim, o);
%! assert (s.trend, o.shape);
%! assert (miss (s) < 0.3 * miss (fitSurrogate (few, truth (few), lim)));
%! o.shape = [0, 0; 0, 0; 1, 1];
%! assert (ischar (fitSurrogate (X, truth (X), lim, o).trend));
%! % what it does not know gets a slope of its own
%! o.shape = [3, -1; NaN, NaN; 1, 0];
%! assert (miss (fitSurrogate (few, truth (few), lim, o)) < 0.2);
%!error id=DEcalioc:fitSurrogate:runFailed
%! fitSurrogate (X, NaN (20, 1), lim);
%!error id=DEcalioc:fitSurrogate:badShape fitSurrogate (X, z', lim);

% SPDX-License-Identifier: GPL-3.0-only
