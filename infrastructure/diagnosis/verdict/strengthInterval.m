% STRENGTHINTERVAL  Strengths that the data do not contradict, from a sample.
%
% CALL: Q = strengthInterval (PHI, WEIGHT, RANGE, SCALE)
%
%   PHI      n x 1, sample of the posterior of a strength
%   WEIGHT   n x 1, weights >= 0
%   RANGE    1 x 2, limits of the strength
%   SCALE    scalar, standard deviation of the prior, normal around 0 and cut to
%            RANGE
%   Q        1 x 3: median, lower and upper end
%
% The interval holds the strengths whose marginal likelihood (density over
% prior, by a kernel estimate that reflects at the limits) is above exp (-1.353)
% of the largest: half the 90 % point of chi2 with one degree. On a normal
% likelihood that is the 90 % interval. An interval of a given posterior mass
% never holds a strength at the end of its range where the data say little; when
% this one was chosen, it held 89 % of the strengths of left-out LIGGGHTS runs
% and that one 82 %, at equal width (docs/gap-figures.md has today's share).

function q = strengthInterval (phi, weight, range, scale)
  grid = linspace (range(1), range(2), 201)';
  weight = weight(:) / sum (weight);
  middle = weight' * phi;
  spread = sqrt (weight' * (phi - middle).^2);
  % Silverman (1986), 3.4.2, with the effective number of points
  width = max (0.9 * spread * sum (weight.^2)^0.2, 0.005);
  kernel = @(x) exp (-0.5 * ((grid - x') / width).^2);
  % reflected at both ends, where half of each kernel would be lost (Silverman 1986,
  % 2.10)
  density = (kernel (phi) + kernel (2 * range(1) - phi) + ...
             kernel (2 * range(2) - phi)) * weight;
  % over its prior: an interval of the posterior would never hold the end of the range
  likelihood = density ./ exp (-0.5 * (grid / scale).^2);
  inside = grid(likelihood >= exp (-1.353) * max (likelihood));
  step = grid(2) - grid(1);
  % the grid knows each end within half a step
  lo = max (inside(1) - step / 2, range(1));
  hi = min (inside(end) + step / 2, range(2));
  q = [weightedQuantile(phi, weight, 0.5), lo, hi];
end

%!shared normal
%! normal = sqrt (2) * erfinv (2 * ((1:4000)' - 0.5) / 4000 - 1);
%!test
%! % a normal likelihood under a flat prior: the usual 90 % interval
%! q = strengthInterval (0.5 + 0.1 * normal, ones (4000, 1), [0, 1], 100);
%! assert (q, 0.5 + 0.1 * [0, -1.645, 1.645], 0.015);
%!test
%! % data that say nothing exclude nothing, whatever the prior prefers
%! phi = (1:4000)' / 4000;
%! assert (strengthInterval (phi, ones (4000, 1), [0, 1], 1e3)(2:3), [0, 1]);
%! assert (strengthInterval (phi, exp (-2 * phi.^2), [0, 1], 0.5)(2:3), [0, 1]);
%!test
%! % a likelihood that grows towards the limit reaches it
%! phi = 0.7 + 0.3 * (1:4000)' / 4000;
%! q = strengthInterval (phi, exp (10 * phi), [-1, 1], 100);
%! assert (q(3), 1);
%! assert (q(2), 1 - 0.1353, 0.02);

% SPDX-License-Identifier: GPL-3.0-only
