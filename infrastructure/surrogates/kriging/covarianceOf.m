% COVARIANCEOF  Prior covariance of a surrogate between two lists of sets.
%
% CALL: [K, D] = covarianceOf (SURROGATE, U, V)
%
% U, V       n x d and m x d, sets in the unit box
% K          n x m, of the standardised response
% D          n x (d + 1), where V are the runs (solver.unit): K alpha,
%            differentiated by the logarithms of the variance and of the d
%            inverse ranges, alpha held

function [K, D] = covarianceOf (surrogate, U, V)
  theta = surrogate.model.param(:)';
  r2 = squares (U, V, exp (theta(2:end)));
  K = exp (theta(1)) * correlationOf (surrogate.covariance, r2);
  if nargout < 2
    return
  end
  alpha = surrogate.solver.alpha;
  w2 = exp (2 * theta(2:end));
  d = numel (w2);
  [k, slope] = correlationOf (surrogate.covariance, ...
                              squares (U, V, sqrt (w2)));
  % (u_j - x_j)^2 = u_j^2 - 2 u_j x_j + x_j^2, summed over the runs x
  M = slope * [alpha, V .* alpha, V.^2 .* alpha];
  near = U.^2 .* M(:, 1) - 2 * U .* M(:, 2:d + 1) + M(:, d + 2:end);
  D = exp (theta(1)) * [k * alpha, 2 * w2 .* near];
end

function r2 = squares (U, V, rates)
  A = U .* rates;
  B = V .* rates;
  r2 = max (sum (A.^2, 2) + sum (B.^2, 2)' - 2 * A * B', 0);
end

%!test
%! % as stk has it; the slopes as differences have it
%! X = [0, 0.1; 1, 0; 0.2, 1; 1, 0.9; 0.4, 0.3];
%! s = fitSurrogate (X, [1; 4; 2; 5; 9], [0, 0; 1, 1], ...
%!                   struct ('covariance', 'matern32'));
%! U = [0.1, 0.2; 0.5, 0.9; 0.3, 0.3];
%! K = feval (s.model.covariance_type, s.model.param, U, X, -1);
%! assert (covarianceOf (s, U, X), K, 1e-12 * max (K(:)));
%! at = @(s) covarianceOf (s, U, X) * s.solver.alpha;
%! [~, D] = covarianceOf (s, U, X);
%! for j = 1:3
%!   h = 1e-5 * ((1:3)' == j);
%!   [up, down] = deal (s);
%!   up.model.param = s.model.param(:) + h;
%!   down.model.param = s.model.param(:) - h;
%!   assert (D(:, j), (at (up) - at (down)) / 2e-5, 1e-6 * max (abs (D(:))));
%! end
