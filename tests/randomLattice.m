% RANDOMLATTICE  Latin hypercube of random points, from rand.
%
% CALL: POINTS = randomLattice (N, D)
%
%   POINTS  N x D in [0, 1], one point in each of N slices of every coordinate
%
% Not stk's: the laboratories keep the runs that their seeds have always given.
%
% See also: foreignPlan, standInGap

function points = randomLattice (n, d)
  points = zeros (n, d);
  for j = 1:d
    points(:, j) = (randperm (n)' - rand (n, 1)) / max (n, 1);
  end
end

%!assert (sort (ceil (5 * randomLattice (5, 2))), (1:5)' * [1, 1])
%!assert (size (randomLattice (0, 3)), [0, 3])

% SPDX-License-Identifier: GPL-3.0-only
