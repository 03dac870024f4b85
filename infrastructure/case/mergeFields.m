% MERGEFIELDS  Fields of one struct put over those of another.
%
% CALL: S = mergeFields (S, GIVEN)
%
% S      scalar struct: the defaults, or what there is
% GIVEN  scalar struct; each of its fields takes the place of that of s

function s = mergeFields (s, given)
  for name = fieldnames (given)'
    s.(name{1}) = given.(name{1});
  end
end

%!test
%! s = mergeFields (struct ('a', 1, 'b', {{2}}), struct ('b', [], 'c', {{3}}));
%! assert (s, struct ('a', 1, 'b', [], 'c', {{3}}));
%!assert (mergeFields (struct ('a', 1), struct ()), struct ('a', 1))
