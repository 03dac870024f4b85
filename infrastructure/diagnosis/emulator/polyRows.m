% POLYROWS  Evaluates monomials at points.
%
% CALL: B = polyRows (POWERS, Q)
%
%   POWERS   q x d, exponents, one monomial a row
%   Q        n x d, points
%   B        n x q, B(i,k) = prod_j Q(i,j) ^ POWERS(k,j)

function B = polyRows (powers, Q)
  B = ones (rows (Q), rows (powers));
  for j = 1:columns (Q)
    q = Q(:, j);
    % every power by one product, and once for all monomials
    table = [ones(size (q)), q];
    for k = 2:max ([powers(:, j); 0])
      table = [table, table(:, end) .* q];
    end
    B = B .* table(:, powers(:, j) + 1);
  end
end

%!assert (polyRows ([0, 0; 1, 2], [2, 3; 1, -1]), [1, 18; 1, 1])
%!assert (size (polyRows (zeros (0, 2), ones (3, 2))), [3, 0])

% SPDX-License-Identifier: GPL-3.0-only
