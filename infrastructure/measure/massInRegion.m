% MASSINREGION  Mass of the grains whose centres lie in a box.
%
% CALL: [MASS, ISINSIDE] = massInRegion (GRAINS, DENSITY, REGION)
%
% GRAINS    n x 4, columns x y z radius (m), a frame of readDump
% DENSITY   of the grains, scalar or n x 1 (kg/m3)
% REGION    2 x 3, lower and upper limits along x, y and z (m); -Inf and Inf
%           leave a side open
% MASS      scalar (kg); a grain counts whole or not at all
% ISINSIDE  n x 1 logical, which grains count
%
% Of any other shape: massInRegion (GRAINS(mask, :), DENSITY, [-Inf; Inf] .*
% ones (1, 3)) with a mask of one's own. Clumps: their members overlap; count
% grains instead of spheres there.
%
% Throws DEcalioc:massInRegion:badShape.
%
% See also: readDump, surfaceAt
function [mass, isInside] = massInRegion (grains, density, region)
  if ~isequal (size (region), [2, 3])
    error ('DEcalioc:massInRegion:badShape', ...
           ['massInRegion: REGION must be 2 x 3, lower limits above upper ' ...
            'ones, got %d x %d.'], rows (region), columns (region));
  end
  centres = grains(:, 1:3);
  isInside = all (centres >= region(1, :) & centres <= region(2, :), 2);
  each = 4 / 3 * pi * grains(:, 4).^3 .* density;
  mass = sum (each(isInside));
end

%!test
%! grains = [0, 0, 1, 1; 0, 0, 3, 1; 5, 0, 1, 1];
%! [mass, isInside] = massInRegion (grains, 3 / (4 * pi), ...
%!                                  [-1, -Inf, 0; 1, Inf, 2]);
%! assert (mass, 1, 1e-12);
%! assert (isInside, [true; false; false]);
%! assert (massInRegion (grains, [1; 1; 2] * 3 / (4 * pi), ...
%!                       [-Inf; Inf] .* ones (1, 3)), 4, 1e-12);
%!error id=DEcalioc:massInRegion:badShape massInRegion (zeros (1, 4), 1, [0, 1])

% SPDX-License-Identifier: GPL-3.0-only
