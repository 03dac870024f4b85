% COVARIANCESLOPES  What the covariance with the runs weighs, by its parameters.
%
% CALL: D = covarianceSlopes (SURROGATE, U)
%
%   U   n x d, sets in the unit box
%   D   n x k, K alpha of the standardised response, K the covariance of U with
%       the runs, differentiated by each of the k parameters of the covariance,
%       alpha (solver.alpha) held
%
% Of stk_rbf_NAME, and not of stk_NAMEcov_aniso once for each parameter: these compare
% all their arguments with those of the call before, which took a sixth of a
% calibration on the surrogates.

function D = covarianceSlopes (surrogate, U)
  model = surrogate.model;
  s = surrogate.solver;
  variance = exp (model.param(1));
  weight = exp (model.param(2:end))(:)';
  kernel = regexprep (func2str (model.covariance_type), ...
                      '^stk_(\w+?)cov(\w*)_aniso$', 'stk_rbf_$1$2');
  h = stk_dist (U .* weight, s.unit .* weight);
  D = variance * feval (kernel, h, -1) * s.alpha;
  % the distance changes by the square of its part along a parameter over itself
  slope = variance * feval (kernel, h, 1) ./ max (h, eps (1));
  for j = 1:numel (weight)
    part = weight(j) * (U(:, j) - s.unit(:, j)');
    D(:, j + 1) = (slope .* part.^2) * s.alpha;
  end
end

%!test
%! % as differences have it, of each covariance
%! pkg load stk
%! X = [0, 0.1; 1, 0; 0.2, 1; 1, 0.9; 0.4, 0.3];
%! U = [0.1, 0.2; 0.5, 0.9; 0.3, 0.3; X(3, :)];
%! for covariance = {'matern32', 'matern52', 'gauss'}
%!   s = fitSurrogate (X, [1; 4; 2; 5; 9], [0, 0; 1, 1], ...
%!                     struct ('covariance', covariance{1}));
%!   at = @(param) feval (s.model.covariance_type, param, U, s.solver.unit) * ...
%!                 s.solver.alpha;
%!   D = covarianceSlopes (s, U);
%!   for j = 1:3
%!     h = 1e-5 * ((1:3)' == j);
%!     change = at (s.model.param + h) - at (s.model.param - h);
%!     assert (D(:, j), change / 2e-5, 1e-6 * max (abs (D(:))));
%!   end
%! end

% SPDX-License-Identifier: GPL-3.0-only
