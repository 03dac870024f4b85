% INSIDELIMITS  Rows of a table of sets that lie within the box.
%
% CALL: X = insideLimits (X, LIMITS)
%
% X       n x d  sets; runs that were taken in may lie outside
% LIMITS  2 x d  box

function X = insideLimits (X, limits)
  X = X(all (X >= limits(1, :) & X <= limits(2, :), 2), :);
end

%!assert (insideLimits ([1, 2; 3, 2; 1, 9], [0, 0; 2, 4]), [1, 2])
%!assert (insideLimits (zeros (0, 2), [0, 0; 2, 4]), zeros (0, 2))
