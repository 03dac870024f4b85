% INTEGRATIONPOINTS  Draws the fixed random points of the evidence integrals.
%
% CALL: BASE = integrationPoints (N, D, SEED)
%
%   N      scalar, number of points
%   D      scalar, largest number of unknowns
%   SEED   scalar; the same points serve every hypothesis, so that their
%          evidences err alike. The random state is left as it was.
%   BASE   struct normal (N x D), uniform (N x D), root (N x 1: sqrt of a
%          chi-square with 7 degrees of freedom over 7)

function base = integrationPoints (N, D, seed)
  restore = seedRandom (seed);
  base.normal = randn (N, D);
  base.normal(2:2:N, :) = -base.normal(1:2:N - 1, :);
  base.uniform = rand (N, D);
  base.root = sqrt (sum (randn (N, 7).^2, 2) / 7);
end

%!test
%! a = integrationPoints (10, 2, 1);
%! assert (a.normal, integrationPoints(10, 2, 1).normal);
%! assert (mean (a.normal), [0, 0], 1e-15);

% SPDX-License-Identifier: GPL-3.0-only
