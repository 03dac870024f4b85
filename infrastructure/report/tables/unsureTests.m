% UNSURETESTS  Further tests that promise much, for which runs were too few to be sure.
%
% CALL: NAMES = unsureTests (GAP)
%
%   GAP    decoded gap/gap.json
%   NAMES  1 x n cell of texts, the most promising first

function names = unsureTests (gap)
  tests = jsonList (gap, {'next'});
  isOpen = cellfun (@(t) isequal (jsonAt (t, {'sure'}), false) && ...
                    t.gain >= gap.thresholds.adviseAt, tests);
  names = cellfun (@(t) t.test, tests(isOpen), 'UniformOutput', false);
end

%!test
%! gap.thresholds.adviseAt = 0.2;
%! gap.next = struct ('test', {'a', 'b', 'c'}, 'gain', {0.1, 1.2, 0.1}, ...
%!                    'sure', {true, false, false});
%! assert (unsureTests (gap), {'b'});
%! assert (unsureTests (struct ('next', [])), cell (1, 0));

% SPDX-License-Identifier: GPL-3.0-only
