% COVARIANCEOF  Prior covariance of a surrogate between two lists of sets.
%
% CALL: K = covarianceOf (SURROGATE, U, V)
%
% SURROGATE  scalar struct of fitSurrogate
% U, V       n x d and m x d, sets in the unit box
% K          n x m, of the standardised response
%
% See also: krigingTerms, correlationOf

function K = covarianceOf (surrogate, U, V)
  model = surrogate.model;
  w = exp (model.param(2:end))';
  A = U .* w;
  B = V .* w;
  r2 = max (sum (A.^2, 2) + sum (B.^2, 2)' - 2 * A * B', 0);
  K = exp (model.param(1)) * correlationOf (surrogate.covariance, r2);
end

%!test
%! % as stk has it
%! pkg load stk
%! s = fitSurrogate ([0, 0; 1, 0; 0, 1; 1, 1; 0.4, 0.3], (1:5)', ...
%!                   [0, 0; 1, 1], struct ('covariance', 'matern32'));
%! U = [0.1, 0.2; 0.5, 0.9; 0.3, 0.3];
%! V = [0.2, 0.2; 1, 0];
%! K = feval (s.model.covariance_type, s.model.param, U, V, -1);
%! assert (covarianceOf (s, U, V), K, 1e-12 * max (K(:)));
