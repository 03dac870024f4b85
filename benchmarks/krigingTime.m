% KRIGINGTIME  What a fit and a prediction by stk cost, and what quickCost saves.
%
% CALL: octave-cli benchmarks/krigingTime.m SEEDS [CSVFILE]
%
%   SEEDS  e.g. 1:5
%
% A response of four parameters that saturates and multiplies, with 2 % noise, 10
% to 100 runs; affine trend, Matern 5/2, the noise estimated. Seconds of
% processor, medians over the seeds: 20 likelihoods with slopes (stk_param_relik,
% quickCost); a fit of the toolbox with either, a fit with stk's own tolerance; a
% prediction of one set and of 1000 in one call (predictSurrogate with the doubt
% of the parameters, stk_predict). Largest differences: of quickCost, relative, in
% value and slopes; of the cost where the toolbox stops and where stk does.
%
% See also: fitSurrogate, estimateModel, quickCost, predictSurrogate

1;

function figures = compareOnce (n, seed)
  rand ('twister', seed);
  randn ('twister', seed);
  d = 4;
  X = rand (n, d);
  z = X(:, 1) ./ (X(:, 1) + 0.3) .* (1 + X(:, 2)) + 0.5 * sqrt (X(:, 3)) + ...
      0.02 * randn (n, 1);
  P = rand (1000, d);
  s = fitSurrogate (X, z, [zeros(1, d); ones(1, d)], ...
                    struct ('trend', 'affine', 'covariance', 'matern52'));
  s.solver.open = parameterSpread (s);
  [U, y] = deal (s.solver.unit, s.solver.y);
  model = krigingModel ('affine', 'matern52', d, setfield (s, 'noise', []));
  quick = setfield (model, 'criterion', @quickCost);
  gradient = @(m) nthargout (1:2, @fitCost, m, U, y, s.theta);
  figures = [timeOf(@() twenty (@() gradient (model))), ...
             timeOf(@() twenty (@() gradient (quick))), ...
             timeOf(@() estimateModel (model, U, y)), ...
             timeOf(@() estimateModel (quick, U, y)), ...
             timeOf(@() byStk (model, U, y)), ...
             timeOf(@() predicted (s, P(1, :))), ...
             timeOf(@() stk_predict (s.solver.posterior, P(1, :))), ...
             timeOf(@() predicted (s, P)), ...
             timeOf(@() stk_predict (s.solver.posterior, P))];
  [there, ours] = deal (vertcat (gradient (model){:}), vertcat (gradient (quick){:}));
  best = fitCost (model, U, y, byStk (model, U, y));
  figures(end + 1) = max (abs (ours - there)) / max (abs (there));
  figures(end + 1) = fitCost (model, U, y, estimateModel (model, U, y)) - best;
end

function theta = byStk (model, U, y)
  [param, noise] = stk_param_estim (model, U, y, model.param, ...
                                    model.lognoisevariance);
  theta = [param; noise];
end

function predicted (s, P)
  [~, ~] = predictSurrogate (s, P);
end

function twenty (f)
  for i = 1:20
    f ();
  end
end

function seconds = timeOf (f)
  start = cputime ();
  f ();
  seconds = cputime () - start;
end

addpath (fileparts (mfilename ('fullpath')));
startBenchmarks ();
given = argv ();
seeds = sscanf (given{1}, '%d:%d')';
titles = {'runs', 'relik20', 'quick20', 'fit', 'quick_fit', 'stk_fit', ...
          'one_set', 'stk_one_set', 'sets1000', 'stk_sets1000', ...
          'quick_difference', 'cost_left'};
R = [];
for n = [10, 25, 100]
  figures = cell2mat (arrayfun (@(seed) compareOnce (n, seed), ...
                                (seeds(1):seeds(end))', 'UniformOutput', false));
  R(end + 1, :) = [n, median(figures(:, 1:9), 1), max(figures(:, 10:11), [], 1)];
  printf ('%s\n', sprintf ('%9.2g', R(end, :)));
end
if numel (given) > 1
  lines = arrayfun (@(i) rowText (num2cell (R(i, :))), 1:rows (R), ...
                    'UniformOutput', false);
  writeTable (given{2}, [{strjoin(titles, ',')}, lines]);
end

% SPDX-License-Identifier: GPL-3.0-only
