% SAMESET  Rows of a table that are one and the same parameter set.
%
% CALL: YES = sameSet (X, P, LIMITS)
%
% X       n x d, parameter sets
% P       1 x d
% LIMITS  2 x d, the box (toUnit); what differs by less than 1e-12 of it is
%         rounding
% YES     n x 1 logical

function yes = sameSet (X, p, limits)
  yes = all (abs (toUnit (X, limits) - toUnit (p, limits)) <= 1e-12, 2);
end

%!assert (sameSet ([1, 2; 1, 2 + 1e-14; 1, 2.1], [1, 2], [0, 0; 1, 9]), ...
%!        [true; true; false])

% SPDX-License-Identifier: GPL-3.0-only
