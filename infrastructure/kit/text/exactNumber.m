% EXACTNUMBER  A number as text that reads back as the same bits.
%
% CALL: TEXT = exactNumber (X)
%
%   X     real scalar
%   TEXT  15 significant digits where they do (toDigits), else 17

function text = exactNumber (x)
  text = sprintf ('%.15g', x);
  if sscanf (text, '%f') ~= x
    text = sprintf ('%.17g', x);
  end
end

%!assert (exactNumber (0.1), '0.1')
%!assert (exactNumber (1/3), '0.33333333333333331')
%!assert ({exactNumber(NaN), exactNumber(-Inf), exactNumber(3)}, ...
%!        {'NaN', '-Inf', '3'})

% SPDX-License-Identifier: GPL-3.0-only
