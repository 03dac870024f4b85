% COVARIANCEROOT  Root of a covariance that rounding may have left indefinite.
%
% CALL: [R, U] = covarianceRoot (C)
%
%   C  n x n, symmetric but for rounding
%   R  n x n: R * R' = C, what is negative in it taken as 0
%   U  n x n, axes of C: R * U' is the symmetric root
%
% Cholesky's root needs a positive definite matrix. Sums and differences of
% fitted covariances are that only up to rounding: the nearest one that is
% (Higham 1988, Linear Algebra Appl. 103) leaves the negative axes out.

function [R, U] = covarianceRoot (C)
  [U, L] = eig ((C + C') / 2);
  R = U .* sqrt (max (diag (L)', 0));
end

%!test
%! C = [2, 1, 0; 1, 2, 1; 0, 1, 2];
%! [R, U] = covarianceRoot (C);
%! assert (R * R', C, 1e-12);
%! S = R * U';
%! assert ({S * S, S}, {C, S'}, 1e-12);
%! R = covarianceRoot (diag ([4, -1e-9]));
%! assert (R * R', diag ([4, 0]), 1e-12);

% SPDX-License-Identifier: GPL-3.0-only
