% FROMSYMMETRIC  Parameter sets of places in [-1, 1], as the diagnosis counts.
%
% CALL: X = fromSymmetric (THETA, LIMITS)
%
%   THETA   n x p, -1 at the lower and 1 at the upper limits
%   LIMITS  2 x p, or 3 x p, the box, see toUnit
%   X       n x p
%
% The emulator is a polynomial: around the middle of the box its odd and even
% terms are uncorrelated, and its fit well conditioned.
%
% See also: toUnit

function X = fromSymmetric (theta, limits)
  X = mean (limits(1:2, :)) + theta .* (limits(2, :) - limits(1, :)) / 2;
  isLog = any (limits(3:end, :), 1);
  if any (isLog)
    X(:, isLog) = fromUnit ((theta(:, isLog) + 1) / 2, limits(:, isLog));
  end
end

%!assert (fromSymmetric ([-1, 0; 1, 0.5], [1, 4; 3, 8]), [1, 6; 3, 7]);
%!assert (fromSymmetric ([-1; 0; 1], [1; 100; 1]), [1; 10; 100], 1e-13);
%!test
%! box = [1, 0; 100, 5; 1, 0];
%! theta = [-1, 0.2; 0.3, 1];
%! assert (2 * toUnit (fromSymmetric (theta, box), box) - 1, theta, 1e-13);

% SPDX-License-Identifier: GPL-3.0-only
