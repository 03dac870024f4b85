% QUICKCOST  As stk_param_relik, for few runs and in a twentieth of its time.
%
% CALL: [C, BYCOVARIANCE, BYNOISE] = quickCost (MODEL, XI, ZI)
%
%   arguments and results are those of stk_param_relik; MODEL is one of
%   krigingModel whose noise is a number, or known for each run
%
% A criterion for stk_param_estim, for the refits of a calibration alone: see
% docs/method.md for what they would cost with that of stk.

function [C, byCovariance, byNoise] = quickCost (model, xi, zi)
  [n, d] = size (xi);
  S = reshape ((permute (xi, [1, 3, 2]) - permute (xi, [3, 1, 2])).^2, [], d);
  variance = exp (model.param(1));
  weight = exp (2 * model.param(2:end)(:));
  [k, slope] = correlationOf (model.covariance_type, S * weight);
  K = variance * reshape (k, n, n);
  noise = exp (model.lognoisevariance(:)) .* ones (n, 1);
  H = feval (model.lm, xi);
  [Q, ~] = qr (H);
  W = Q(:, columns (H) + 1:end);
  U = stk_cholcov (W' * (K + diag (noise)) * W);
  F = U' \ W';
  v = F * zi;
  [penalty, g] = priorOf (model);
  C = 0.5 * (rows (U) * log (2 * pi) + v' * v) + sum (log (diag (U))) + penalty;
  if nargout > 1
    z = F' * v;
    M = F' * F - z * z';
    g(1) = g(1) + 0.5 * sum (M(:) .* K(:));
    g(2:d + 1) = g(2:d + 1) + variance * ((M(:) .* slope)' * S)' .* weight;
    byCovariance = g(1:d + 1);
    byNoise = g(d + 2:end);
    if isscalar (model.lognoisevariance)
      byNoise = byNoise + 0.5 * noise' * diag (M);
    end
  end
end

% What the priors add to the cost and its gradient, which is empty for a noise
% that is known.
function [penalty, g] = priorOf (model)
  theta = model.param(:) - model.prior.mean;
  g = theta ./ model.prior.sd.^2;
  penalty = 0.5 * (theta' * g);
  if isfield (model, 'noiseprior')
    u = (model.lognoisevariance - model.noiseprior.mean) / model.noiseprior.sd;
    g(end + 1) = u / model.noiseprior.sd;
    penalty = penalty + 0.5 * u^2;
  end
end

% Correlation and its slope by the squared scaled distance.
function [k, slope] = correlationOf (kernel, r2)
  switch func2str (kernel)
    case 'stk_materncov52_aniso'
      t = sqrt (10 * r2);
      e = exp (-t);
      k = (1 + t + t.^2 / 3) .* e;
      slope = -10 / 6 * (1 + t) .* e;
    case 'stk_materncov32_aniso'
      t = sqrt (6 * r2);
      e = exp (-t);
      k = (1 + t) .* e;
      slope = -3 * e;
    case 'stk_gausscov_aniso'
      k = exp (-r2);
      slope = -k;
  end
end

%!test
%! % as stk has it, values and gradients, of each covariance and noise
%! pkg load stk
%! rand ('twister', 1);
%! U = rand (12, 3);
%! y = sin (3 * U(:, 1)) + U(:, 2);
%! of = struct ('noise', [], 'extra', [], 'prior', [], 'scatter', [], ...
%!              'scale', 1, 'quick', false, 'published', false);
%! known = setfield (of, 'noise', 0.1 * U(:, 1));
%! for covariance = {'matern52', 'matern32', 'gauss'}
%!   for trend = {'constant', 'affine', 'quadratic'}
%!     model = krigingModel (trend{1}, covariance{1}, 3, of);
%!     model.param = model.param + [0.3; -0.2; 0.5; 0.1];
%!     model.lognoisevariance = -4;
%!     [C, g, h] = stk_param_relik (model, U, y);
%!     [c, s, t] = quickCost (model, U, y);
%!     assert ([c; s; t], [C; g; h], -1e-8);
%!     model = krigingModel (trend{1}, covariance{1}, 3, known);
%!     [C, g, h] = stk_param_relik (model, U, y);
%!     [c, s, t] = quickCost (model, U, y);
%!     assert ([c; s], [C; g], -1e-8);
%!     assert (isempty (h) && isempty (t));
%!   end
%! end

% SPDX-License-Identifier: GPL-3.0-only
