% TOUNIT  Parameter sets in the unit box.
%
% CALL: U = toUnit (X, LIMITS)
%
% X       n x d, parameter sets
% LIMITS  2 x d, the box; a third row (0 or 1) where a parameter counts in
%         logarithms, between positive limits; of a surrogate also a fourth
%         (bend k: u becomes (exp (k u) - 1) / (exp (k) - 1), see bendInputs)
% U       n x d, 0 at the lower and 1 at the upper limits
%
% The one map between parameters and the box that everything works in, with
% fromUnit. In logarithms nothing lies farther below the box than its width:
% a value of 0 does not.

function U = toUnit (X, limits)
  lo = limits(1, :);
  U = (X - lo) ./ (limits(2, :) - lo);
  for j = find (any (limits(3:min (end, 3), :), 1))
    span = log (limits(2, j) / lo(j));
    U(:, j) = max (log (max (X(:, j), 0) / lo(j)) / span, -1);
  end
  for j = find (any (limits(4:end, :), 1))
    U(:, j) = expm1 (limits(4, j) * U(:, j)) / expm1 (limits(4, j));
  end
end

%!assert (toUnit ([1, 5; 2, 7], [1, 4; 3, 8]), [0, 0.25; 0.5, 0.75]);
%!test
%! limits = [1e5, 0; 1e9, 2; 1, 0];
%! assert (toUnit ([1e5, 0; 1e7, 1; 1e9, 2], limits), [0; 0.5; 1] * [1, 1], ...
%!         eps (1));
%! assert (toUnit ([0, 1; -3, 1], limits), [-1, 0.5; -1, 0.5]);
%!test
%! U = toUnit ([0; 5; 10], [0; 10; 0; 3]);
%! assert (U, [0; expm1(1.5) / expm1(3); 1], eps (1));
%! assert (toUnit ([1; 10; 100], [1; 100; 1; -3])(2), ...
%!         expm1 (-1.5) / expm1 (-3), 1e-14);
%!assert (toUnit (zeros (0, 2), [1, 1; 2, 2; 1, 0]), zeros (0, 2));

% SPDX-License-Identifier: GPL-3.0-only
