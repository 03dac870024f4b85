% KRIGINGTIME  Likelihood, fit and prediction: ours beside those of stk.
%
% CALL: octave-cli benchmarks/krigingTime.m [SEEDS]
%
%   SEEDS  e.g. 1:5
%
% A response of four parameters that saturates and multiplies, with 2 % noise, 10
% to 100 runs; the same trend (affine) and covariance (Matern 5/2), the noise
% estimated. Times are seconds of processor, medians over the seeds, of 20
% likelihoods with slopes, one fit, and 1000 predictions; the differences are
% those at equal parameters, over the spread of the response.
%
% See also: fitSurrogate, prepareFit, predictSurrogate

1;

function measureAll (seeds)
  printf (['| runs | likelihood: ours, stk (s) | fit: ours, stk (s) | 1000 ', ...
           'predictions: ours, stk (s) | difference of means, of deviations |\n', ...
           '|---|---|---|---|---|\n']);
  for n = [10, 25, 100]
    figures = zeros (numel (seeds), 8);
    for i = 1:numel (seeds)
      figures(i, :) = compareOnce (n, seeds(i));
    end
    printf ('| %d | %.3f, %.3f | %.2f, %.2f | %.3f, %.3f | %.0e, %.0e |\n', n, ...
            median (figures(:, 1:6)), max (figures(:, 7:8)));
  end
end

function figures = compareOnce (n, seed)
  rand ('twister', seed);
  randn ('twister', seed);
  d = 4;
  X = rand (n, d);
  z = X(:, 1) ./ (X(:, 1) + 0.3) .* (1 + X(:, 2)) + 0.5 * sqrt (X(:, 3)) + ...
      0.02 * randn (n, 1);
  P = rand (1000, d);
  limits = [zeros(1, d); ones(1, d)];
  kind = struct ('trend', 'affine', 'covariance', 'matern52');
  [fitTime, s] = timeOf (@() fitSurrogate (X, z, limits, kind));
  model = s.model;
  [U, y] = deal (s.solver.unit, s.solver.y);
  fit = prepareFit (U, y, 'affine', 'matern52', []);
  figures(1) = timeOf (@() twenty (@() nthargout (1:2, fit.cost, s.theta)));
  figures(2) = timeOf (@() twenty (@() nthargout (1:3, @stk_param_relik, model, ...
                                                  U, y)));
  figures(3) = fitTime;
  start = stk_model ('stk_materncov52_aniso', d);
  start.lm = stk_lm_affine ();
  figures(4) = timeOf (@() estimated (start, U, y));
  [figures(5), m, v] = timeOf (@() predictSurrogate (s, P));
  known = stk_model_gpposterior (model, U, y);
  [figures(6), there] = timeOf (@() stk_predict (known, P));
  figures(7) = max (abs (m - s.shift - s.scale * there.mean)) / s.scale;
  s.solver.open = [];                      % stk has no doubt of the parameters
  [~, v] = predictSurrogate (s, P);
  figures(8) = max (abs (sqrt (v / s.factor) - s.scale * sqrt (there.var))) / ...
               s.scale;
end

function twenty (f)
  for i = 1:20
    f ();
  end
end

function [param, lnv] = estimated (model, U, y)
  model.lognoisevariance = NaN;            % to be estimated
  [param0, lnv0] = stk_param_init (model, U, y);
  model.param = param0;
  model.lognoisevariance = lnv0;
  [param, lnv] = stk_param_estim (model, U, y, param0, lnv0);
end

function [seconds, varargout] = timeOf (f)
  varargout = cell (1, nargout - 1);
  start = cputime ();
  if nargout > 1
    [varargout{:}] = f ();
  else
    f ();
  end
  seconds = cputime () - start;
end

addpath (fileparts (mfilename ('fullpath')));
startBenchmarks ();
pkg ('load', 'stk');
args = argv ()';
measureAll (str2num ([args, {'1:5'}]{1}));
