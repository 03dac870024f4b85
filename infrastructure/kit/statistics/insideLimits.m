% INSIDELIMITS  Rows of a table of sets that lie within the box.
%
% CALL: [X, ISIN] = insideLimits (X, LIMITS)
%       [X, ISIN] = insideLimits (X, LIMITS, BEYOND)
%
% X       n x d  sets; runs that were taken in may lie outside
% LIMITS  2 x d  box (toUnit)
% BEYOND  share of the box that a set may lie beyond a limit (0)
% ISIN    n x 1  logical, which rows

function [X, isIn] = insideLimits (X, limits, beyond)
  if nargin > 2
    limits = fromUnit ([-beyond; 1 + beyond] .* ones (1, columns (limits)), ...
                       limits);
  end
  isIn = all (X >= limits(1, :) & X <= limits(2, :), 2);
  X = X(isIn, :);
end

%!assert (insideLimits ([1, 2; 3, 2; 1, 9], [0, 0; 2, 4]), [1, 2])
%!assert (insideLimits (zeros (0, 2), [0, 0; 2, 4]), zeros (0, 2))
%!assert (insideLimits ([-1; 4; 6], [0; 4], 0.25), [-1; 4])

% SPDX-License-Identifier: GPL-3.0-only
