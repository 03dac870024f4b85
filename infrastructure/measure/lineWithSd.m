% LINEWITHSD  Straight line through a surface, and how well it is known.
%
% CALL: [ANGLE, SD, LINE] = lineWithSd (X, Z)
%
%   X, Z   1 x n, stations (rising, evenly spaced) and heights there, same unit
%   ANGLE  inclination (deg), positive where the surface rises along X
%   SD     its standard uncertainty (deg)
%   LINE   scalar struct: middle (mean of X), slope, height (at the middle), and
%          their variances slopeVar, heightVar
%
% Residuals on a bed of grains are alike over the width of a bump, however dense the
% stations lie: n of them count as n / (1 + 2 sum of their correlations up to the
% first one below 0). All NaN for fewer than 5 stations.

function [angle, sd, line] = lineWithSd (x, z)
  isKnown = isfinite (z);
  [x, z] = deal (x(isKnown)(:), z(isKnown)(:));
  line = struct ('middle', NaN, 'slope', NaN, 'height', NaN, 'slopeVar', NaN, ...
                 'heightVar', NaN);
  [angle, sd] = deal (NaN);
  m = numel (x);
  if m < 5
    return
  end
  line.middle = mean (x);
  A = [x - line.middle, ones(m, 1)];
  c = A \ z;
  rest = z - A * c;
  n = max (3, m / correlated (rest));
  vars = rest' * rest / m / (n - 2) * [m / sumsq(A(:, 1)), 1];
  [line.slope, line.height] = deal (c(1), c(2));
  [line.slopeVar, line.heightVar] = deal (vars(1), vars(2));
  angle = atand (c(1));
  sd = 180 / pi * sqrt (vars(1)) / (1 + c(1)^2);
end

% As how many stations one counts.
function s = correlated (rest)
  s = 1;
  k = 1;
  total = max (rest' * rest, realmin);
  r = rest(1:end - 1)' * rest(2:end) / total;
  while r > 0 && k < numel (rest) - 1
    s = s + 2 * r;
    k = k + 1;
    r = rest(1:end - k)' * rest(1 + k:end) / total;
  end
end

%!test
%! x = linspace (0, 1, 50);
%! [angle, sd, line] = lineWithSd (x, 0.5 * x + 3);
%! assert ([angle, sd], [atand(0.5), 0], 1e-9);
%! assert (line.height, 3.25, 1e-9);
%!test
%! % bumps of grains, eight stations wide: the uncertainty is the scatter
%! state = randn ('state');
%! randn ('state', 5);
%! found = zeros (200, 2);
%! for k = 1:200
%!   bumps = conv (randn (1, 407), ones (1, 8) / sqrt (8), 'valid');
%!   [found(k, 1), found(k, 2)] = lineWithSd (linspace (0, 1, 400), 0.02 * bumps);
%! end
%! randn ('state', state);
%! assert (mean (found(:, 1)), 0, 0.1);
%! assert (sqrt (mean (found(:, 2).^2)) / std (found(:, 1)), 1, 0.2);
%!assert (isnan (lineWithSd (1:4, 1:4)))

% SPDX-License-Identifier: GPL-3.0-only
