% COVARIANCESLOPES  What the covariance with the runs weighs, by its parameters.
%
% CALL: D = covarianceSlopes (SURROGATE, U)
%
%   U   n x d, sets in the unit box
%   D   n x k, K alpha of the standardised response, K the covariance of U with
%       the runs, differentiated by each of the k parameters of the covariance,
%       alpha (solver.alpha) held

function D = covarianceSlopes (surrogate, U)
  model = surrogate.model;
  s = surrogate.solver;
  D = zeros (rows (U), numel (model.param));
  for j = 1:columns (D)
    slope = feval (model.covariance_type, model.param, U, s.unit, j);
    D(:, j) = slope * s.alpha;
  end
end

%!test
%! % as differences have it
%! pkg load stk
%! X = [0, 0.1; 1, 0; 0.2, 1; 1, 0.9; 0.4, 0.3];
%! s = fitSurrogate (X, [1; 4; 2; 5; 9], [0, 0; 1, 1], ...
%!                   struct ('covariance', 'matern32'));
%! U = [0.1, 0.2; 0.5, 0.9; 0.3, 0.3];
%! at = @(param) feval (s.model.covariance_type, param, U, s.solver.unit) * ...
%!               s.solver.alpha;
%! D = covarianceSlopes (s, U);
%! for j = 1:3
%!   h = 1e-5 * ((1:3)' == j);
%!   change = at (s.model.param + h) - at (s.model.param - h);
%!   assert (D(:, j), change / 2e-5, 1e-6 * max (abs (D(:))));
%! end
