% SILHOUETTE  Free surface of grains as a camera sees it from the side.
%
% CALL: HEIGHT = silhouette (GRAINS, X)
%
% GRAINS  n x 4, columns x y z radius (m), a frame of readDump
% X       1 x m, stations along x (m)
% HEIGHT  1 x m, highest point of any grain above each station (m); NaN where
%         no grain covers the station
%
% A grain with its centre at (x_i, z_i) reaches
%   z_i + sqrt (r_i^2 - (X - x_i)^2)   for |X - x_i| < r_i.
%
% See also: surfaceLine, readDump
function height = silhouette (grains, X)
  chord2 = grains(:, 4).^2 - (X - grains(:, 1)).^2;
  top = grains(:, 3) + sqrt (max (chord2, 0));
  top(chord2 < 0) = -Inf;
  height = max (top, [], 1);
  height(isinf (height)) = NaN;
end

%!test % one grain: apex, flank, outside
%! h = silhouette ([0, 0, 2, 1], [0, 0.6, 3]);
%! assert (h, [3, 2.8, NaN], 10 * eps);
%!assert (silhouette ([0, 0, 2, 1; 0, 5, 7, 1], 0), 8)
%!assert (size (silhouette (zeros (5, 4), 1:3)), [1, 3])

% SPDX-License-Identifier: GPL-3.0-only
