% BOXPOINTS  Fills the box [-1, 1] evenly, a third of the points drawn outwards.
%
% CALL: POINTS = boxPoints (D, N)
%
%   D       scalar, dimensions;  N  scalar, number of points
%   POINTS  N x D, always the same: a Halton sequence of stk; every third point
%           moved to the faces, where polynomials go wrong

function points = boxPoints (d, n)
  points = 2 * double (stk_sampling_halton_rr2 (n, d)) - 1;
  outer = 1:3:n;
  % density of an arcsine, as the nodes of Chebyshev polynomials have
  points(outer, :) = sin (pi / 2 * points(outer, :));
end

%!test
%! points = boxPoints (3, 300);
%! assert (size (points), [300, 3]);
%! assert (max (abs (points(:))) <= 1);
%! assert (max (abs (mean (points))) < 0.1);
%! assert (boxPoints (3, 300), points);

% SPDX-License-Identifier: GPL-3.0-only
