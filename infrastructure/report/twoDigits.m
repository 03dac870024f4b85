% TWODIGITS  A number to two digits, without an exponent: 100, not 1e+02.
%
% CALL: TEXT = twoDigits (X)
%
%   X     scalar real

function text = twoDigits (x)
  text = sprintf ('%.2g', x);
  if abs (x) >= 99.5
    text = sprintf ('%.0f', x);
  end
end

%!assert (twoDigits (100), '100')
%!assert (twoDigits (-134.2), '-134')
%!assert (twoDigits (3.14), '3.1')
%!assert (twoDigits (99.4), '99')

% SPDX-License-Identifier: GPL-3.0-only
