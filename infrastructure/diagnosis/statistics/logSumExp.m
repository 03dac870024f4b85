% LOGSUMEXP  Adds numbers that are given by their logarithms, row by row.
%
% CALL: S = logSumExp (A)
%
%   A   n x m, logarithms (-Inf allowed)
%   S   n x 1, log (sum (exp (A), 2)) without overflow

function s = logSumExp (A)
  top = max (A, [], 2);
  top(~isfinite (top)) = 0;
  s = top + log (sum (exp (A - top), 2));
end

%!assert (logSumExp ([0, 0; 1000, 1000]), [0; 1000] + log (2), 1e-12)
%!assert (logSumExp ([-Inf, -Inf]), -Inf)

% SPDX-License-Identifier: GPL-3.0-only
