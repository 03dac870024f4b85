% POLYPOWERS  Lists the exponents of all monomials up to a total degree.
%
% CALL: POWERS = polyPowers (D, DEGREE)
%
%   D        scalar, number of variables
%   DEGREE   scalar, largest total degree
%   POWERS   q x D, one monomial a row, by total degree; the first is 1

function powers = polyPowers (d, degree)
  powers = zeros (1, 0);
  for j = 1:d
    n = rows (powers);
    grown = zeros (0, j);
    for b = 0:degree
      grown = [grown; powers, repmat(b, n, 1)];
    end
    % cut after each variable: of ten there would be a million rows before
    powers = grown(sum (grown, 2) <= degree, :);
  end
  % the constant comes first, learnEffect adds an offset to it
  [~, order] = sort (sum (powers, 2));
  powers = powers(order, :);
end

%!assert (polyPowers (2, 1), [0, 0; 1, 0; 0, 1])
%!assert (rows (polyPowers (4, 3)), nchoosek (7, 3))
%!assert (max (sum (polyPowers (3, 2), 2)), 2)

% SPDX-License-Identifier: GPL-3.0-only
