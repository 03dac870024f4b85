% TODIGITS  Rounds numbers to the digits that every program keeps.
%
% CALL: X = toDigits (X)
%
%   X  real array, any shape; 15 significant digits
%
% A number of 15 digits is the same one after it was written and read again,
% also by a program that writes no more: LIGGGHTS prints a variable with 15, so
% that of two variables set to one number of 17 the second would be another.
% The order of numbers is kept.

function x = toDigits (x)
  if ~isempty (x)
    x(:) = sscanf (sprintf ('%.15g ', x), '%f');
  end
end

%!assert (toDigits ([1/3, 0.7; -pi * 1e-200, 12]), ...
%!        [0.333333333333333, 0.7; -3.14159265358979e-200, 12])
%!assert (toDigits (0.1 + 0.2), 0.3)
%!assert (toDigits ([NaN, Inf, -Inf]), [NaN, Inf, -Inf])
%!assert (toDigits (zeros (0, 3)), zeros (0, 3))
%!test
%! x = 10.^(-300 + 600 * rand (1, 500)) .* randn (1, 500);
%! assert (toDigits (x), x, -5e-15);
%! assert (toDigits (toDigits (x)), toDigits (x));

% SPDX-License-Identifier: GPL-3.0-only
