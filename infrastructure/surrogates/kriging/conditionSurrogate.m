% CONDITIONSURROGATE  Surrogate from runs and known parameters.
%
% CALL: SURROGATE = conditionSurrogate (CHOICE, BASE)
%
% CHOICE  struct: trend, covariance (names of fitSurrogate), param and
%         lognoisevariance of the stk model in the unit box and the standardised
%         response
% BASE   struct: name, X (n x d), z (n x 1), limits (2 x d), shift and scale (of
%        the standardised response (z - shift) / scale); optional extra (n x 1,
%        one more input, see unitInputs), prior, quick and published (see krigingModel),
%        scatter (see noisePrior) and noiseLaw (1 x 2: log variance where extra is 0, its slope)
%
% stk factors the covariance once (solver.posterior, for stk_predict), and gives
% the leave-one-out residuals in closed form (Dubrule 1983). factor widens the
% prediction variance where the standardised residuals are larger than chance
% allows. df is what the smoother leaves to the noise, trace (noise Q) = n - trace
% (hat) with Q = K^-1 - K^-1 H (H' K^-1 H)^-1 H' K^-1, and what was known of the
% noise beforehand (noisePrior: a log variance known to within sd is what 2 / sd^2
% freedoms tell), at least a third of the rows beyond the trend. solver.alpha and
% solver.beta are the weights of the covariances with the runs and of the trend in
% the mean.

function surrogate = conditionSurrogate (choice, base)
  base = mergeFields (struct ('extra', [], 'noiseLaw', [], 'prior', [], ...
                              'scatter', [], 'quick', false, ...
                              'published', false), base);
  n = numel (base.z);
  unit = unitInputs ([base.X, base.extra], base.limits, columns (base.extra));
  y = (base.z - base.shift) / base.scale;
  model = krigingModel (choice.trend, choice.covariance, columns (unit));
  model.param = choice.param;
  model.lognoisevariance = choice.lognoisevariance;
  noise = exp (model.lognoisevariance(:));
  % without a prior the noise may vanish, and runs lie close to each other
  for id = {'STK:stk_cholcov:AddingRegularizationNoise', ...
            'Octave:nearly-singular-matrix', 'Octave:singular-matrix'}
    warning ('off', id{1}, 'local');
  end
  posterior = stk_model_gpposterior (model, unit, y);
  [left, residual] = stk_predict_leaveoneout (posterior);
  loo = double (residual)(:, 1);
  looStd = double (residual)(:, 2);
  q = 1 ./ (double (left)(:, 2) + noise);          % of Q
  [K, H] = stk_make_matcov (model, unit);
  nTrend = columns (H);
  weights = [K, H; H', zeros(nTrend)] \ [y; zeros(nTrend, 1)];

  surrogate = struct ('name', base.name, 'model', model);
  for field = {'X', 'z', 'limits', 'extra', 'noiseLaw', 'prior', 'scatter', ...
               'shift', 'scale', 'quick', 'published'}
    surrogate.(field{1}) = base.(field{1});
  end
  surrogate.noiseVar = mean (noise) * base.scale^2;
  surrogate.theta = model.param(:);
  if ~isempty (base.noiseLaw)
    surrogate.noiseVar = exp (base.noiseLaw(1)) * base.scale^2;
    surrogate.theta = [model.param(:); base.noiseLaw(:)];
  elseif isscalar (noise)
    surrogate.theta = [model.param(:); model.lognoisevariance];
  end
  surrogate.looResidual = loo * base.scale;
  surrogate.looStd = looStd;
  surrogate.Q2 = 1 - sum (loo.^2) / sum ((y - mean (y)).^2);
  surrogate.trend = choice.trend;
  surrogate.covariance = choice.covariance;
  surrogate.factor = max (1, mean (looStd.^2) - 2 * sqrt (2 / n));
  [~, open] = noisePrior (base.scatter, base.scale);
  surrogate.df = max ([3, sum(noise .* q) + 2 / open^2, ...
                       (n - nTrend) / 3]);
  surrogate.score = -0.5 * sum (log (2 * pi ./ q) + looStd.^2);
  surrogate.solver = struct ('unit', unit, 'y', y, 'posterior', posterior, ...
                             'alpha', weights(1:n), ...
                             'beta', weights(n + 1:end), 'open', []);
  surrogate.nChoice = n;
  [surrogate.leftOut, surrogate.suspect, surrogate.aside, ...
   surrogate.dropped] = deal ([]);
  surrogate.warning = qualityWarning (surrogate);
end

function text = qualityWarning (surrogate)
  text = '';
  if isConstant (surrogate.z)
    text = 'the response is constant';
  elseif ~(surrogate.Q2 > 0.5)
    text = sprintf (['leave-one-out Q2 = %.2f: the plan says little about ' ...
                     'this response'], surrogate.Q2);
  end
end

%!shared X, z, lim, s
%! rand ('twister', 3);
%! randn ('twister', 3);
%! lim = [0, 10; 2, 30];
%! X = lim(1, :) + rand (14, 2) .* (lim(2, :) - lim(1, :));
%! z = 3 + X(:, 1) + sin (X(:, 2) / 5) + 0.02 * randn (14, 1);
%! s = fitSurrogate (X, z, lim);

%!test
%! % closed form equals brute force with the same parameters
%! i = 5;
%! k = true (14, 1);
%! k(i) = false;
%! base = struct ('name', '', 'X', X(k, :), 'z', z(k), 'limits', lim, ...
%!                'shift', s.shift, 'scale', s.scale);
%! r = conditionSurrogate (mergeFields (s, s.model), base);
%! r.factor = 1;
%! [m, v] = predictSurrogate (r, X(i, :));
%! assert (s.looResidual(i), z(i) - m, 1e-6);
%! assert (s.looStd(i), (z(i) - m) / sqrt (v + s.noiseVar), 1e-4);

%!test
%! % the weights are those of the mean, and the freedoms those of the smoother
%! [K, H] = stk_make_matcov (s.model, s.solver.unit);
%! bare = setfield (s.model, 'lognoisevariance', -Inf);
%! k = stk_make_matcov (bare, s.solver.unit);
%! mean = H * s.solver.beta + k * s.solver.alpha;
%! assert (s.shift + s.scale * mean, predictSurrogate (s, X), 1e-6);
%! Q = inv (K) - K \ H * inv (H' / K * H) * (H' / K);
%! df = trace (exp (s.model.lognoisevariance) * Q) + 2 / 1.6^2;
%! assert (s.df, max (df, (14 - columns (H)) / 3), 1e-6);

% SPDX-License-Identifier: GPL-3.0-only
