% SLOPEBYBINS  Inclination of a surface in each of several stretches.
%
% CALL: [ANGLES, SDS] = slopeByBins (X, Z, EDGES)
%
%   X, Z    1 x n, stations (rising, evenly spaced) and heights (silhouette,
%           pictureOutline), same unit; NaN where nothing is seen
%   EDGES   1 x (k + 1), rising
%   ANGLES  1 x k, inclination (deg), positive where the surface rises along X; NaN
%           with fewer than 5 stations
%   SDS     1 x k, standard uncertainties (deg), see lineWithSd
%
% For a surface that is not straight: S-shaped in a fast drum, concave below a heap.

function [angles, sds] = slopeByBins (x, z, edges)
  [angles, sds] = deal (NaN (1, numel (edges) - 1));
  for k = 1:numel (angles)
    isIn = x >= edges(k) & x < edges(k + 1);
    [angles(k), sds(k)] = lineWithSd (x(isIn), z(isIn));
  end
end

%!test
%! x = linspace (0, 2, 200);
%! z = x .* (x < 1) + (1 + 0.5 * (x - 1)) .* (x >= 1);
%! [angles, sds] = slopeByBins (x, z, [0, 1, 2.1, 3]);
%! assert (angles, [45, atand(0.5), NaN], 1e-6);
%! assert (sds, [0, 0, NaN], 1e-6);

% SPDX-License-Identifier: GPL-3.0-only
