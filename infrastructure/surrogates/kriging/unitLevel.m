% UNITLEVEL  How coarse runs are, as an input of a surrogate.
%
% CALL: U = unitLevel (COARSE, E, T)
%       U = unitLevel (COARSE, E)        n x T, of all targets
%
%   COARSE  scalar struct of newProblem: levels L x v, column 1 x T
%   E       n x v, values of the level variables
%   T       number of the target
%   U       n x 1: 0 at the last level, which counts, 1 at the first, affine in
%           the value between and beyond; zeros where the target's model has no
%           levels

function u = unitLevel (coarse, E, t)
  if nargin < 3
    targets = 1:numel (coarse.column);
    u = arrayfun (@(t) unitLevel (coarse, E, t), targets, 'UniformOutput', false);
    u = [u{:}];
    return
  end
  c = coarse.column(t);
  u = zeros (rows (E), 1);
  if c > 0
    ends = coarse.levels([1, end], c);
    u = (E(:, c) - ends(2)) / (ends(1) - ends(2));
  end
end

%!test
%! coarse = struct ('levels', [4; 3; 2], 'column', [1, 0]);
%! assert (unitLevel (coarse, [4; 3; 2; 1.5], 1), [1; 0.5; 0; -0.25]);
%! assert (unitLevel (coarse, [4; 3], 2), [0; 0]);
%! assert (unitLevel (coarse, [4; 3]), [1, 0; 0.5, 0]);

% SPDX-License-Identifier: GPL-3.0-only
