% JSONNUMBER  A number deep inside decoded JSON; NaN where it is not there.
%
% CALL: X = jsonNumber (ROOT, PATH [, OTHER])
%
%   ROOT, PATH  see jsonAt;  OTHER  instead of NaN

function x = jsonNumber (root, path, x)
  if nargin < 3
    x = NaN;
  end
  found = jsonAt (root, path);
  if (isnumeric (found) || islogical (found)) && ~isempty (found)
    x = found(1);
  end
end

%!assert (jsonNumber (struct ('a', 3), {'a'}), 3)
%!assert (isnan (jsonNumber (struct ('a', []), {'a'})))
%!assert (jsonNumber ([], {'a'}, 0), 0)

% SPDX-License-Identifier: GPL-3.0-only
