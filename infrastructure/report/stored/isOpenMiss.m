% ISOPENMISS  Of which targets the runs and all runs together say something else.
%
% CALL: YES = isOpenMiss (MISSES)
%
%   MISSES  1 x n struct of listMisses: state and runs are read
%   YES     1 x n logical

function yes = isOpenMiss (misses)
  yes = strcmp ({misses.state}, 'open') & [misses.runs] > 0;
end

%!test
%! misses = struct ('state', {'open', 'open', 'met'}, 'runs', {2, 0, 2});
%! assert (isOpenMiss (misses), [true, false, false]);
%! assert (isempty (isOpenMiss (misses([]))));

% SPDX-License-Identifier: GPL-3.0-only
