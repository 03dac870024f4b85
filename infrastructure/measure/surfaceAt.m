% SURFACEAT  Height of the free surface of grains above points of the ground.
%
% CALL: HEIGHT = surfaceAt (GRAINS, X, Y)
%
% GRAINS  n x 4, columns x y z radius (m), a frame of readDump
% X, Y    1 x m, points (m)
% HEIGHT  1 x m, top of the highest grain above each point (m); 0 where there
%         is none
%
% See also: silhouette, radialProfile, readDump
function height = surfaceAt (grains, X, Y)
  chord2 = grains(:, 4).^2 - (X - grains(:, 1)).^2 - (Y - grains(:, 2)).^2;
  top = grains(:, 3) + sqrt (max (chord2, 0));
  top(chord2 < 0) = 0;
  height = max ([top; zeros(size (X))], [], 1);
end

%!test % apex, flank, outside
%! h = surfaceAt ([0, 0, 2, 1], [0, 0, 5], [0, 0.6, 0]);
%! assert (h, [3, 2.8, 0], 10 * eps);

% SPDX-License-Identifier: GPL-3.0-only
