% POLYSLOPE  Evaluates the derivative of polynomials along one variable.
%
% CALL: D = polySlope (POWERS, COEF, Q, J)
%
%   POWERS   q x d, exponents, one monomial a row
%   COEF     q x T, coefficients of T polynomials
%   Q        n x d, points
%   J        scalar, the variable
%   D        n x T, derivative by variable J at the points
%
% See also: polyRows

function D = polySlope (powers, coef, Q, j)
  with = powers(:, j) > 0;
  left = powers(with, :);
  scaled = coef(with, :) .* left(:, j);
  left(:, j) = left(:, j) - 1;
  D = polyRows (left, Q) * scaled;
end

%!test
%! % d/dx (3 x^2 y + y) = 6 x y
%! assert (polySlope ([2, 1; 0, 1], [3; 1], [2, 5], 1), 60);
%! assert (polySlope ([2, 1; 0, 1], [3; 1], [2, 5], 2), 13);
