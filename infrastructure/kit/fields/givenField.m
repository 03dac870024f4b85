% GIVENFIELD  Field of a struct, or a default where it is absent or empty.
%
% CALL: VALUE = givenField (S, FIELD, DEFAULT)
%
%   S        scalar struct;  FIELD  text;  DEFAULT  anything

function value = givenField (s, field, default)
  value = default;
  if isfield (s, field) && ~isempty (s.(field))
    value = s.(field);
  end
end

%!assert (givenField (struct ('a', 3), 'a', 1), 3)
%!assert (givenField (struct ('a', []), 'a', 1), 1)
%!assert (givenField (struct (), 'a', 'x'), 'x')

% SPDX-License-Identifier: GPL-3.0-only
