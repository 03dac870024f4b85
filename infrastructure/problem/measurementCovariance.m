% MEASUREMENTCOVARIANCE  Covariance of errors that are alike along a series.
%
% CALL: C = measurementCovariance (SD, SERIES, COORDINATE, LENGTHS [, SHARED])
%
%   SD          1 x T, standard uncertainties
%   SERIES      1 x T, targets with one number > 0 belong to one series
%   COORDINATE  1 x T, place on the series
%   LENGTHS     1 x T, correlation length in its unit; 0: independent
%   SHARED      1 x T, the part of SD that a whole series shares, as it was
%               measured in the same sessions (0)
%   C           T x T, positive definite where all SD are above 0
%
% C_ij = sd_i sd_j exp (-|at_i - at_j| / L) + shared_i shared_j within a series,
% 0 elsewhere, with sd^2 - shared^2 for sd^2.
% Targets of one series with lengths L_i and L_j of their own: L is the root
% mean square of the two, and C_ij has the factor sqrt (2 L_i L_j / (L_i^2 +
% L_j^2)), without which C would be no covariance (Paciorek and Schervish
% 2006). A millionth of the variance is added on the diagonal: two values at
% one place are never quite the same.

function C = measurementCovariance (sd, series, coordinate, lengths, shared)
  if nargin < 5
    shared = zeros (size (sd));
  end
  squares = (lengths'.^2 + lengths.^2) / 2;
  factor = sqrt (lengths' * lengths ./ squares);
  R = factor .* exp (-abs (coordinate' - coordinate) ./ sqrt (squares));
  isSame = series' == series & series > 0;
  R(~(isSame & (lengths' > 0 & lengths > 0))) = 0;
  R(1:numel (sd) + 1:end) = 1 + 1e-6;
  alone = sqrt (max (sd.^2 - shared.^2, 0));
  isSame(1:numel (sd) + 1:end) = true;
  C = (alone' * alone) .* R + (shared' * shared) .* isSame;
  C(1:numel (sd) + 1:end) = sd.^2 * (1 + 1e-6);
end

%!test
%! C = measurementCovariance ([1, 2, 3], [1, 1, 0], [0, 5, 5], [5, 5, 5]);
%! assert (C, [1, 2 / e, 0; 2 / e, 4, 0; 0, 0, 9], 1e-5);
%!test
%! % what a series shares, beside errors of its own; alone, all of it
%! C = measurementCovariance ([5, 5, 5], [1, 1, 0], [0, 1, 2], [0, 0, 0], ...
%!                            [3, 3, 3]);
%! assert (C, [25, 9, 0; 9, 25, 0; 0, 0, 25], 1e-4);
%! C = measurementCovariance ([5, 5], [1, 1], [0, 1], [2, 2], [5, 5]);
%! assert (C, [25, 25; 25, 25], 1e-4);
%! assert (min (eig (C)) > 0);
%!test
%! % two values at one place, other series, targets without a length
%! C = measurementCovariance (ones (1, 5), [1, 1, 1, 2, 2], ...
%!                            [3, 3, 3, 3, 3], [1, 1, 0, 1, 1]);
%! assert (C, blkdiag ([1, 1; 1, 1], 1, [1, 1; 1, 1]), 1e-5);
%! assert (min (eig (C)) > 5e-7);
%!test
%! % lengths that differ within a series still give a covariance
%! at = 0:0.1:3;
%! C = measurementCovariance (ones (size (at)), ones (size (at)), at, ...
%!                            0.05 + 4 * mod (1:numel (at), 2));
%! assert (C, C');
%! assert (min (eig (C)) > 0);
%! assert (C(1, 1), 1 + 1e-6, 1e-12);

% SPDX-License-Identifier: GPL-3.0-only
