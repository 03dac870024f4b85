% ROWSOF  Some lines of readings.
%
% CALL: LINES = rowsOf (LINES, K)
%
%   LINES  struct of n x 1 arrays, see varianceComponents
%   K      m x 1, numbers of lines or logical

function lines = rowsOf (lines, k)
  lines = structfun (@(column) column(k), lines, 'UniformOutput', false);
end

%!test
%! lines = rowsOf (struct ('value', [1; 2; 3], 'mean', [7; 8; 9]), [3; 1]);
%! assert (lines, struct ('value', [3; 1], 'mean', [9; 7]));

% SPDX-License-Identifier: GPL-3.0-only
