% CLOSUREOF  Measures how much of a gap a cure removes, noise taken out.
%
% CALL: C = closureOf (BEFORE, AFTER, METRIC, OPTIONS)
%
%   BEFORE  struct of deviationOf, without the effect: r (1 x n), F (n x n,
%           covariance of r if there is no gap), E (B x n, draws of it), nu
%   AFTER   the same with the effect, with draws of the same measurement
%   METRIC  n x n, in which r is measured: inverse of the noise of the targets
%   OPTIONS of gapOptions: significance, leftAt, hiddenAt
%   C       struct
%     gapP      chance that noise makes as much as BEFORE.r without a gap
%     largestZ  largest |r| of BEFORE, in its standard deviations
%     removable logical: gapP below significance, or largestZ above leftAt
%     free      directions that the fit with the effect leaves to noise; 0: it
%               has as many unknowns as targets and meets them whatever they are
%     closure   share of the gap that is gone, NaN where nothing is removable,
%               or nothing free
%     interval90  1 x 2
%     share     B x 1, draws of the closure (NaN: as of no gap at all)
%
% closure = 1 - gap (AFTER) / gap (BEFORE), gap = r METRIC r' - trace (METRIC F)
% which noise alone makes 0 on average, whatever was fitted.
%
% gapP is that of r F^-1 r' (chi-square; with estimated variances Fisher's F),
% without the directions in which parameters hide hiddenAt of all; one
% target of many may be off by much and leave it large, therefore largestZ.
%
% The interval is what the estimate less its error may be. The error of a gap g,
% e METRIC e' - trace + 2 g METRIC e', is drawn with e from E: measurement,
% packing, surrogate and seeds. Targets are not drawn: they are what they are,
% and a gap in one of ten would be left out of a third of all draws.

function c = closureOf (before, after, metric, options)
  [c.gapP, c.largestZ] = chanceOf (before, metric, options.hiddenAt);
  [~, ~, c.free] = chanceOf (after, metric, options.hiddenAt);
  c.removable = c.gapP < options.significance || c.largestZ > options.leftAt;
  [gap, miss] = gapOf (before, metric);
  [left, leftError] = gapOf (after, metric);
  c.closure = NaN;
  c.interval90 = [NaN, NaN];
  room = gap - miss;
  c.share = 1 - (left - leftError) ./ room;
  % a draw in which noise makes the whole gap has nothing to close
  c.share(room <= 0) = NaN;
  if c.removable && gap > 0 && c.free > 0
    c.closure = 1 - left / gap;
    sure = c.share(isfinite (c.share));
    c.interval90 = weightedQuantile (sure, ones (size (sure)), [0.05, 0.95]);
  end
end

function [gap, miss] = gapOf (d, metric)
  square = d.r * metric * d.r';
  noise = sum (sum (metric .* d.F));
  % noise alone makes this 0 in the mean, whatever was fitted
  gap = square - noise;
  g = d.r * sqrt (max (gap, 0) / max (square, realmin));
  E = d.E * metric;
  miss = sum (E .* d.E, 2) - noise + 2 * E * g';
end

function [p, z, m] = chanceOf (d, metric, hiddenAt)
  % along the axes of F in units of the noise: 1 is free, 0 hidden by parameters
  L = chol (inv (metric), 'lower');
  F = L \ d.F / L';
  [U, lambda] = eig ((F + F') / 2);
  lambda = diag (lambda)';
  kept = lambda > 1 - hiddenAt;
  x = (d.r / L') * U;
  q = sum (x(kept).^2 ./ lambda(kept));
  m = sum (kept);
  nu = min (d.nu, 1e4);
  p = 1;
  if m > 0
    % upper tail of Fisher's F: q / m with m and nu degrees of freedom
    p = betainc (nu / (nu + q), nu / 2, m / 2);
  end
  % where parameters hide all of a target's error there is nothing to divide by
  sd = sqrt (max (diag (d.F), 1e-3 * diag (inv (metric))))';
  z = max (abs (d.r) ./ sd);
end

%!function d = drawn (r, q, E)
%!  % n targets of noise 1, of which q freedoms were taken
%!  n = numel (r);
%!  P = diag ([zeros(1, q), ones(1, n - q)]);
%!  d = struct ('r', r * P, 'F', P, 'E', E(:, 1:n) * P, 'nu', Inf);
%!endfunction

%!shared draw, o
%! o = gapOptions ([]);
%! randn ('twister', 1);
%! E = randn (1000, 40);
%! draw = @(r, q) drawn (r, q, E);
%!test
%! % a cure that leaves noise closes all but chance; by hand
%! r = [0, 0, ones(1, 8)];
%! c = closureOf (draw (5 * r, 1), draw (r, 2), eye (10), o);
%! assert (c.closure, 1 - (8 - 8) / (200 - 9), 1e-12);
%! assert (c.interval90(1) > 0.9 && c.interval90(2) < 1.1);
%! assert (c.removable);
%! assert (c.gapP < 1e-9);
%! c = closureOf (draw (5 * r, 1), draw (5 * r, 1), eye (10), o);
%! assert (c.closure, 0);
%! assert (c.interval90, [0, 0], 1e-9);
%!test
%! % a gap of twenty deviations in one target of ten is seen, of four in sixty
%! r = [zeros(1, 9), 20];
%! c = closureOf (draw (r, 0), draw (0 * r, 1), eye (10), o);
%! assert (c.removable && c.gapP < 1e-9);
%! assert (c.interval90(1) > 0.8);
%! r = [zeros(1, 39), 4.2];
%! c = closureOf (draw (r, 0), draw (0 * r, 1), eye (40), o);
%! assert (c.gapP > 0.05 && c.removable);
%!test
%! % two targets, and a fit that meets both whatever they are
%! c = closureOf (draw ([9, 9], 1), draw ([9, 9], 2), eye (2), o);
%! assert (c.removable && c.free == 0);
%! assert (c.closure, NaN);
%!test
%! % nothing to remove
%! c = closureOf (draw (ones (1, 10), 0), draw (ones (1, 10), 1), eye (10), o);
%! assert (c.removable, false);
%! assert (c.closure, NaN);
%! assert (c.gapP, 0.44, 0.01);

% SPDX-License-Identifier: GPL-3.0-only
