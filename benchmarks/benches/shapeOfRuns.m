% SHAPEOFRUNS  How a result follows the parameters, of many stored runs.
%
% CALL: [C, Q2] = shapeOfRuns (X, Z, LIMITS, PHI)
%
%   X, Z    n x d, n x 1, sets and a result (NaN: none);  LIMITS  2 x d
%   PHI     n x v, strengths of effects in these runs: further inputs, 0 in what is
%           learnt; v may be 0
%   C       d x 2, slope and curvature along each parameter in the box, in the unit of
%           the result: the parabolas whose sum is nearest to the Kriging model of the
%           runs
%   Q2      of that model: below 0.3 the runs say little of the result
%
% See also: benchForms, knownShapes

function [C, Q2] = shapeOfRuns (X, z, limits, phi)
  ok = isfinite (z);
  phi = phi(ok, any (phi(ok, :) ~= 0, 1));
  ends = [min(phi, [], 1); max(phi, [], 1)];
  ends(1, :) = min (ends(1, :), 0);
  ends(2, :) = max (ends(2, :), 0);
  s = fitSurrogate ([X(ok, :), phi], z(ok), [limits(1:2, :), ends], ...
                    struct ('trend', 'affine', 'covariance', 'matern52', 'quick', true));
  [n, d] = deal (400, columns (limits));
  U = sampleBox (n, [0; 1] .* ones (1, d));
  m = predictSurrogate (s, [limits(1, :) + U .* diff(limits(1:2, :)), zeros(n, columns (phi))]);
  b = [ones(n, 1), U, U.^2] \ m;
  C = reshape (b(2:end), d, 2);
  Q2 = s.Q2;
end

%!test
%! pkg load stk
%! rand ('twister', 1);
%! X = rand (40, 2) .* [2, 1];
%! phi = [zeros(20, 1); rand(20, 1)];
%! z = 3 + X(:, 1) - X(:, 2).^2 + 5 * phi;
%! [C, Q2] = shapeOfRuns (X, z, [0, 0; 2, 1], phi);
%! assert (C, [2, 0; 0, -1], 0.2);
%! assert (Q2 > 0.9);

% SPDX-License-Identifier: GPL-3.0-only
