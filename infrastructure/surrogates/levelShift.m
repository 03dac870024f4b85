% LEVELSHIFT  What another level does to a response at a set.
%
% CALL: [SHIFT, SD, NOISESD] = levelShift (S, P, LEVEL)
%
%   S        scalar struct of fitLevels
%   P        1 x d, parameter set
%   LEVEL    scalar, how coarse (unitLevel; below 0: finer than the last level)
%   SHIFT    response there less that at the level that counts; NaN where the
%            surrogate holds no runs of other levels
%   SD       its standard deviation
%   NOISESD  scatter of a run at LEVEL

function [shift, sd, noiseSd] = levelShift (s, p, level)
  [shift, sd, noiseSd] = deal (NaN);
  if level == 0
    [shift, sd, noiseSd] = deal (0, 0, sqrt (s.noiseVar));
  elseif ~isempty (s.extra) && ~any (s.dropped == level)
    [m, ~, S] = krigingPosterior (s, [p, level; p, 0]);
    shift = s.scale * (m(1) - m(2));
    sd = s.scale * sqrt (s.factor * max (0, [1, -1] * S * [1; -1]));
    noiseSd = sqrt (noiseAt (s, level));
  end
end

%!test
%! rand ('twister', 5);
%! X = rand (16, 2);
%! level = [ones(8, 1); zeros(8, 1)];
%! z = 1 + X(:, 1) + 0.3 * level;
%! s = fitLevels (X, z, level, [0, 0; 1, 1], struct ());
%! [shift, sd, noiseSd] = levelShift (s, [0.4, 0.4], 1);
%! assert (shift, 0.3, 0.02);
%! assert (sd < 0.02 && noiseSd < 0.05);
%! assert (levelShift (s, [0.4, 0.4], -0.5), -0.15, 0.05);
%! assert (levelShift (s, [0.4, 0.4], 0), 0);
%! s.extra = [];
%! assert (levelShift (s, [0.4, 0.4], 1), NaN);

% SPDX-License-Identifier: GPL-3.0-only
