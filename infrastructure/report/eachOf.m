% EACHOF  What a function gives for each element of a list.
%
% CALL: OUT = eachOf (F, LIST)
%
%   F     handle of one argument
%   LIST  cell (F gets what is in it), struct array or numbers
%   OUT   1 x n cell

function out = eachOf (f, list)
  map = @arrayfun;
  if iscell (list)
    map = @cellfun;
  end
  out = map (f, reshape (list, 1, []), 'UniformOutput', false);
end

%!assert (eachOf (@(x) x + 1, [1; 2]), {2, 3})
%!assert (eachOf (@upper, {'a'}), {'A'})
%!assert (eachOf (@(s) s.a, struct ('a', {1, 2})), {1, 2})
%!assert (eachOf (@numel, []), cell (1, 0))

% SPDX-License-Identifier: GPL-3.0-only
