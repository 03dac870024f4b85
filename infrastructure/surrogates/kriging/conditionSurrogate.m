% CONDITIONSURROGATE  Surrogate from runs and known parameters.
%
% CALL: SURROGATE = conditionSurrogate (CHOICE, BASE)
%
% CHOICE  struct: trend, covariance (names of fitSurrogate), param and
%         lognoisevariance of the stk model in the unit box and the standardised
%         response
% BASE   struct: name, X (n x d), z (n x 1), limits (2 x d), shift and scale (of
%        the standardised response (z - shift) / scale); optional extra (n x 1,
%        one more input, see unitInputs), prior (see prepareFit), scatter (see
%        noisePrior) and noiseLaw (1 x 2: log variance where extra is 0, its slope)
%
% The covariance is factored once; leave-one-out residuals in closed form
% (Dubrule 1983): with Q = K^-1 - K^-1 H (H' K^-1 H)^-1 H' K^-1 the residual is
% (Q y)_i / Q_ii and its variance 1 / Q_ii. factor widens the prediction
% variance where the standardised residuals are larger than chance allows. df is
% what the smoother leaves to the noise, trace (noise Q) = n - trace (hat), and
% what was known of the noise beforehand (noisePrior: a log variance known to
% within sd is what 2 / sd^2 freedoms tell), at least a third of the rows beyond
% the trend.

function surrogate = conditionSurrogate (choice, base)
  base = mergeFields (struct ('extra', [], 'noiseLaw', [], 'prior', [], ...
                              'scatter', []), base);
  n = numel (base.z);
  unit = unitInputs ([base.X, base.extra], base.limits, columns (base.extra));
  y = (base.z - base.shift) / base.scale;
  model = modelOf (choice, columns (unit));
  K = feval (model.covariance_type, model.param, unit, unit, -1);
  noise = exp (model.lognoisevariance(:));
  K = K + diag (noise .* ones (n, 1)) + ...
      1e-12 * exp (model.param(1)) * full (eye (n));
  H = feval (model.lm, unit);
  L = chol (K, 'lower');
  A = L \ H;
  [~, R] = qr (A, 0);
  b = L \ y;
  beta = R \ (R' \ (A' * b));
  alpha = L' \ (b - A * beta);
  W = chol2inv (L');
  V = (L' \ A) / R;
  q = max (diag (W) - sum (V.^2, 2), eps (diag (W)));
  loo = alpha ./ q;
  looStd = alpha ./ sqrt (q);

  surrogate = struct ('name', base.name, 'model', model);
  for field = {'X', 'z', 'limits', 'extra', 'noiseLaw', 'prior', 'scatter', ...
               'shift', 'scale'}
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
                       (n - size (H, 2)) / 3]);
  surrogate.score = -0.5 * sum (log (2 * pi ./ q) + looStd.^2);
  surrogate.solver = struct ('unit', unit, 'y', y, 'L', L, ...
                             'A', A, 'R', R, 'beta', beta, ...
                             'alpha', alpha, 'open', []);
  surrogate.nChoice = n;
  [surrogate.leftOut, surrogate.suspect, surrogate.aside, ...
   surrogate.dropped] = deal ([]);
  surrogate.warning = qualityWarning (surrogate);
end

function model = modelOf (choice, d)
  kernel = regexprep (choice.covariance, '^(matern|gauss)', '$1cov');
  model = stk_model (['stk_' kernel '_aniso'], d);
  model.lm = feval (['stk_lm_' choice.trend]);
  model.param = choice.param;
  model.lognoisevariance = choice.lognoisevariance;
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
%! % the same as the posterior of stk
%! s.factor = 1;
%! P = lim(1, :) + rand (6, 2) .* (lim(2, :) - lim(1, :));
%! [m, v] = predictSurrogate (s, P);
%! known = stk_model_gpposterior (s.model, s.solver.unit, s.solver.y);
%! y = stk_predict (known, (P - lim(1, :)) ./ diff (lim));
%! assert (m, s.shift + s.scale * y.mean, 1e-7);
%! assert (v, s.scale ^ 2 * y.var, 1e-7);
