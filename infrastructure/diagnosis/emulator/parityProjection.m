% PARITYPROJECTION  Splits a residual into what parameters make and the rest.
%
% CALL: PARITY = parityProjection (J, R)
%
%   J       T x p, slopes of the results, in units of their standard deviation
%   R       T x 1, residual in the same units
%   PARITY  struct
%     rho (n x 1, n = T - rank): N (0, I) where there is no gap, whatever the
%       parameters are (to first order)
%     N (T x n): rho = N' * R
%     unabsorbed, absorbed (scalars): rho' * rho and the rest of R' * R
%     absorbability (T x 1): share of a target's own signal that the parameters
%       can take up; above 0.9 the target is a blind spot
%
% Parity space of fault detection (Gertler 1998): the left null space of J, less
% directions along which half the box moves the results by a hundredth of a
% standard deviation or less: these hide nothing, and where no parameter moves
% anything, slopes are rounding.

function parity = parityProjection (J, R)
  [U, S, ~] = svd (J);
  s = diag (S(1:min (size (S)), 1:min (size (S))));
  rank_ = sum (s > max ([1e-8 * s; 0.01]));
  % left singular vectors beyond the rank: no parameter moves along them
  parity.N = U(:, rank_ + 1:end);
  parity.rho = parity.N' * R;
  parity.unabsorbed = sum (parity.rho.^2);
  parity.absorbed = sum (R.^2) - parity.unabsorbed;
  % diagonal of the projection on the slopes, the leverage of regression
  parity.absorbability = sum (U(:, 1:rank_).^2, 2);
end

%!test
%! % one parameter that moves targets 1 and 2 alike
%! parity = parityProjection ([1; 1; 0], [3; 1; 2]);
%! assert (parity.unabsorbed, 2 + 4, 1e-12);
%! assert (parity.absorbed, 8, 1e-12);
%! assert (parity.absorbability, [0.5; 0.5; 0], 1e-12);
%!test
%! % as many parameters as targets: nothing is left
%! parity = parityProjection (eye (2), [1; 2]);
%! assert (isempty (parity.rho));
%! assert (parity.unabsorbed, 0);
%!test
%! % parameters that move nothing but for rounding hide nothing
%! parity = parityProjection ([1e-13, -2e-13], 5);
%! assert ([parity.rho^2, parity.absorbed], [25, 0], 1e-12);
%! assert (parity.absorbability, 0);

% SPDX-License-Identifier: GPL-3.0-only
