% FITCOST  What stk_param_estim makes least, at given parameters.
%
% CALL: [C, G] = fitCost (MODEL, U, Y, THETA)
%
%   MODEL  struct of krigingModel
%   U, Y   n x d, n x 1, inputs in the unit box, standardised response
%   THETA  parameters of the covariance, and the logarithm of the noise variance
%          where MODEL estimates it
%   C, G   negative log density (restricted likelihood and priors: stk_param_relik,
%          or MODEL.criterion), its gradient by THETA

function [C, g] = fitCost (model, U, y, theta)
  model = stk_set_optimizable_parameters (model, theta);
  if nargout < 2
    C = model.criterion (model, U, y);
  else
    [C, byCovariance, byNoise] = model.criterion (model, U, y);
    g = [byCovariance; byNoise];
  end
end

%!function check (model, theta)
%!  rand ('twister', 1);
%!  X = rand (9, 2);
%!  z = X(:, 1) - X(:, 2).^2;
%!  k = numel (theta);
%!  [~, g] = fitCost (model, X, z, theta);
%!  for j = 1:k
%!    h = 1e-5 * ((1:k)' == j);
%!    dC = fitCost (model, X, z, theta + h) - fitCost (model, X, z, theta - h);
%!    assert (g(j), dC / 2e-5, 1e-4);
%!  end
%!endfunction
%!test
%! % gradient against central differences, priors and noises among it
%! pkg load stk
%! of = struct ('noise', [], 'extra', [], 'prior', [], 'scatter', [], ...
%!              'scale', 1, 'quick', false, 'published', false);
%! check (krigingModel ('affine', 'matern52', 2, of), [-1; 0.2; -0.3; -4]);
%! check (krigingModel ('affine', 'gauss', 2, ...
%!                      setfield (of, 'extra', 1)), [-1; 0.2; -0.3; -4; 0.5]);
%! check (krigingModel ('affine', 'matern32', 2, ...
%!                      setfield (of, 'noise', 0.1 * ones (9, 1))), ...
%!        [-1; 0.2; -0.3]);

% SPDX-License-Identifier: GPL-3.0-only
