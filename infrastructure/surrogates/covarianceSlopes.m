% COVARIANCESLOPES  How the prediction changes with variance and ranges.
%
% CALL: D = covarianceSlopes (SURROGATE, U)
%
% SURROGATE  scalar struct of fitSurrogate
% U          m x d, sets in the unit box
% D          m x (d + 1): k(U, runs) alpha, differentiated by the logarithms of
%            the variance and of the d inverse ranges, alpha held
%
% See also: parameterSpread, krigingTerms

function D = covarianceSlopes (surrogate, U)
  s = surrogate.solver;
  theta = surrogate.model.param(:)';
  w2 = exp (2 * theta(2:end));
  d = numel (w2);
  A = U .* sqrt (w2);
  B = s.unit .* sqrt (w2);
  r2 = max (sum (A.^2, 2) + sum (B.^2, 2)' - 2 * A * B', 0);
  [k, slope] = correlationOf (surrogate.covariance, r2);
  % (u_j - x_j)^2 = u_j^2 - 2 u_j x_j + x_j^2, summed over the runs x
  M = slope * [s.alpha, s.unit .* s.alpha, s.unit.^2 .* s.alpha];
  own = U.^2 .* M(:, 1) - 2 * U .* M(:, 2:d + 1) + M(:, d + 2:end);
  D = exp (theta(1)) * [k * s.alpha, 2 * w2 .* own];
end

%!test
%! % as differences have it
%! pkg load stk
%! X = [0, 0.1; 1, 0; 0.2, 1; 1, 0.9; 0.4, 0.3];
%! s = fitSurrogate (X, [1; 4; 2; 5; 9], [0, 0; 1, 1]);
%! U = [0.3, 0.8; 0.4, 0.3];
%! at = @(s) covarianceOf (s, U, X) * s.solver.alpha;
%! D = covarianceSlopes (s, U);
%! for j = 1:3
%!   h = 1e-5 * ((1:3)' == j);
%!   [up, down] = deal (s);
%!   up.model.param = s.model.param(:) + h;
%!   down.model.param = s.model.param(:) - h;
%!   assert (D(:, j), (at (up) - at (down)) / 2e-5, 1e-6 * max (abs (D(:))));
%! end
