% POLYROWS  Evaluates monomials at points, and their slopes.
%
% CALL: [B, D] = polyRows (POWERS, Q)
%
%   POWERS   q x d, exponents, one monomial a row
%   Q        n x d, points
%   B        n x q, B(i,k) = prod_j Q(i,j) ^ POWERS(k,j)
%   D        1 x d cell of n x q, derivatives of B along each variable
%
% See also: polyPowers

function [B, D] = polyRows (powers, Q)
  [n, d] = size (Q);
  B = ones (n, rows (powers));
  D = cell (1, d * (nargout > 1));
  D(:) = {B};
  for j = 1:d
    top = max ([powers(:, j); 0]);
    table = ones (n, top + 1);
    for k = 1:top
      table(:, k + 1) = table(:, k) .* Q(:, j);
    end
    own = table(:, powers(:, j) + 1);
    B = B .* own;
    if nargout > 1
      for i = [1:j - 1, j + 1:d]
        D{i} = D{i} .* own;
      end
      steep = [zeros(n, 1), table(:, 1:top) .* (1:top)];
      D{j} = D{j} .* steep(:, powers(:, j) + 1);
    end
  end
end

%!assert (polyRows ([0, 0; 1, 2], [2, 3; 1, -1]), [1, 18; 1, 1])
%!assert (size (polyRows (zeros (0, 2), ones (3, 2))), [3, 0])
%!test
%! % x^2 y and y at (2, 5); a variable that no monomial has
%! [B, D] = polyRows ([2, 1, 0; 0, 1, 0], [2, 5, 7]);
%! assert (B, [20, 5]);
%! assert (D, {[20, 0], [4, 1], [0, 0]});
