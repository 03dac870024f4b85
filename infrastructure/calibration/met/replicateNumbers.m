% REPLICATENUMBERS  Numbers of the replicates of sets that are to be run.
%
% CALL: R = replicateNumbers (DATA, P, LIMITS)
%
%   P       n x d, sets, LIMITS  2 x d, the box
%   R       n x 1: 1 for a set that is new, else the next number, so another
%           packing; a set at another level is one more packing, too

function r = replicateNumbers (data, P, limits)
  r = ones (rows (P), 1);
  for i = 1:rows (P)
    earlier = [data.X; P(1:i - 1, :)];
    numbers = [data.replicate; r(1:i - 1)];
    same = sameSet (earlier, P(i, :), limits);
    r(i) = max ([0; numbers(same)]) + 1;
  end
end

%!test
%! data = addRows (newData (1, 1), [1; 2; 1], [1; 1; 1], [1; 1; 4], 'plan');
%! assert (replicateNumbers (data, [1; 3; 1; 3], [0; 5]), [5; 1; 6; 2]);

% SPDX-License-Identifier: GPL-3.0-only
