% FROMUNIT  Parameter sets of places in the unit box.
%
% CALL: X = fromUnit (U, LIMITS)
%
% U       n x d, 0 at the lower and 1 at the upper limits
% LIMITS  2 x d, or 3 x d, the box, see toUnit
% X       n x d, parameter sets

function X = fromUnit (U, limits)
  lo = limits(1, :);
  X = lo + U .* (limits(2, :) - lo);
  for j = find (any (limits(3:end, :), 1))
    X(:, j) = lo(j) * (limits(2, j) / lo(j)).^U(:, j);
    atEnd = U(:, j) == 1;
    X(atEnd, j) = limits(2, j);
  end
end

%!assert (fromUnit ([0, 0.25; 0.5, 0.75], [1, 4; 3, 8]), [1, 5; 2, 7]);
%!test
%! limits = [1e5, 0; 1e9, 2; 1, 0];
%! assert (fromUnit ([0.5, 0.5], limits), [1e7, 1], 1e-8);
%! assert (fromUnit ([0, 0; 1, 1], limits), limits(1:2, :));
%! restore = seedRandom (3);
%! U = rand (50, 2);
%! assert (toUnit (fromUnit (U, limits), limits), U, 1e-14);

% SPDX-License-Identifier: GPL-3.0-only
