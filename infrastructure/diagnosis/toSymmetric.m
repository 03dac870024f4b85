% TOSYMMETRIC  Places in [-1, 1] of parameter sets, as the diagnosis counts.
%
% CALL: THETA = toSymmetric (X, LIMITS)
%
%   X       n x p;  LIMITS  2 x p, or 3 x p, the box, see toUnit
%   THETA   n x p, -1 at the lower and 1 at the upper limits
%
% See also: fromSymmetric

function theta = toSymmetric (X, limits)
  theta = 2 * toUnit (X, limits) - 1;
end

%!assert (toSymmetric ([1, 6; 3, 7], [1, 4; 3, 8]), [-1, 0; 1, 0.5]);
%!test
%! box = [1, 0; 100, 5; 1, 0];
%! theta = [-1, 0.2; 0.3, 1];
%! assert (toSymmetric (fromSymmetric (theta, box), box), theta, 1e-13);

% SPDX-License-Identifier: GPL-3.0-only
