% ONELINE  A text without control characters, for where a line is all that fits.
%
% CALL: TEXT = oneLine (TEXT)
%
%   TEXT  row of char; line ends, tabs and the like become blanks

function text = oneLine (text)
  text(text < 32) = ' ';
end

%!assert (oneLine ("a\nb\tc"), 'a b c')
%!assert (oneLine (''), '')

% SPDX-License-Identifier: GPL-3.0-only
