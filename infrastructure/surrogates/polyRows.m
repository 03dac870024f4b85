% POLYROWS  Evaluates monomials at points.
%
% CALL: B = polyRows (POWERS, Q)
%
%   POWERS   q x d, exponents, one monomial a row
%   Q        n x d, points
%   B        n x q, B(i,k) = prod_j Q(i,j) ^ POWERS(k,j)
%
% See also: polyPowers, polySlope

function B = polyRows (powers, Q)
  B = ones (rows (Q), rows (powers));
  for j = 1:columns (powers)
    top = max (powers(:, j));
    if top > 0
      table = Q(:, j).^(0:top);
      B = B .* table(:, powers(:, j) + 1);
    end
  end
end

%!assert (polyRows ([0, 0; 1, 2], [2, 3; 1, -1]), [1, 18; 1, 1])
%!assert (size (polyRows (zeros (0, 2), ones (3, 2))), [3, 0])
