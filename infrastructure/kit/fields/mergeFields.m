% MERGEFIELDS  Fields of one struct put over those of another.
%
% CALL: S = mergeFields (S, GIVEN)
%       S = mergeFields (S, GIVEN, FIELDS)
%
% S      scalar struct: the defaults, or what there is
% GIVEN  scalar struct; each of its fields takes the place of that of s, or
%        those of FIELDS alone (1 x n cell)

function s = mergeFields (s, given, fields)
  if nargin < 3
    fields = fieldnames (given)';
  end
  for name = fields
    s.(name{1}) = given.(name{1});
  end
end

%!test
%! s = mergeFields (struct ('a', 1, 'b', {{2}}), struct ('b', [], 'c', {{3}}));
%! assert (s, struct ('a', 1, 'b', [], 'c', {{3}}));
%! s = mergeFields (struct (), s, {'c', 'a'});
%! assert (s, struct ('c', {{3}}, 'a', 1));
%!assert (mergeFields (struct ('a', 1), struct ()), struct ('a', 1))

% SPDX-License-Identifier: GPL-3.0-only
