% FARPOINTS  Picks points one by one, each as far as can be from all before.
%
% CALL: [AT, GAP] = farPoints (C, U, N, NEAREST)
%
%   C        m x d, points to choose from;  U  k x d, points that are taken
%   N        number of points to pick
%   NEAREST  m x 1, how far each of C is from anything else (default Inf)
%   AT       1 x N, rows of C;  GAP  N x 1, how far each was when it was picked
%
% Greedy maximin: at most twice as far from the best cover of C by as many
% points (Gonzalez 1985, Theor. Comput. Sci. 38), and independent of N.
%
% See also: planBeside, runForIntervals

function [at, gap] = farPoints (C, U, n, nearest)
  if nargin < 4
    nearest = Inf (rows (C), 1);
  end
  for i = 1:rows (U)
    nearest = min (nearest, sqrt (sum ((C - U(i, :)).^2, 2)));
  end
  at = zeros (1, n);
  gap = zeros (n, 1);
  for k = 1:n
    [gap(k), at(k)] = max (nearest);
    nearest = min (nearest, sqrt (sum ((C - C(at(k), :)).^2, 2)));
  end
end

%!test
%! C = (0:10)' / 10;
%! [at, gap] = farPoints (C, 0, 3);
%! assert (C(at)', [1, 0.5, 0.2], 1e-12);
%! assert (gap', [1, 0.5, 0.2], 1e-12);
%! % walls that count half a step
%! assert (farPoints (C, zeros (0, 1), 1, 2 * min (C, 1 - C)), 6);

% SPDX-License-Identifier: GPL-3.0-only
