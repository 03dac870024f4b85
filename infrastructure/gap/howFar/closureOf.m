% CLOSUREOF  Measures how much of a gap a cure removes, noise taken out.
%
% CALL: C = closureOf (Y, NOISE, BEFORE, AFTER, SCALE)
%
%   Y       1 x n, measured values
%   NOISE   1 x n, variance of Y: measurement and packing of the trials
%   BEFORE  R x n, runs of the calibrated model without the effect, R seeds
%   AFTER   R' x n, runs with the effect
%   SCALE   1 x n, unit of each target (its range over the parameter box)
%   C       struct
%     before, after, floor  root mean square deviations; floor: what noise makes
%     gap       1 x 2, mean square gap before and after, noise taken out (may be
%               negative by chance)
%     closure   (before^2 - after^2) / (before^2 - floor^2); NaN where there is
%               no gap to remove
%     interval90  1 x 2, bootstrap over targets and seeds
%     removable logical, before^2 > floor^2 in 95 % of the bootstrap, and more
%               than noise makes (chi-square, 5 %)
%
% The noise of the means is estimated from the runs and subtracted (once
% more where the bootstrap adds it): mere noise is neither gap nor cure.
%
% See also: measureCorrection

function c = closureOf (y, noise, before, after, scale)
  n = numel (y);
  whole = squares (y, noise, before, after, scale);
  c.before = sqrt (mean (whole.before));
  c.after = sqrt (mean (whole.after));
  c.floor = sqrt (mean (whole.floor));
  c.gap = [mean(whole.before - whole.floor), mean(whole.after - whole.floor1)];
  B = 1000;
  draws = integrationPoints (B, n + rows (before) + rows (after), 7).uniform;
  gain = zeros (B, 1);
  room = zeros (B, 1);
  extra.before = spread (before) ./ scale.^2;
  extra.after = spread (after) ./ scale.^2;
  for b = 1:B
    u = draws(b, :);
    at = 1 + floor (n * u(1:n));
    r0 = 1 + floor (rows (before) * u(n + 1:n + rows (before)));
    r1 = 1 + floor (rows (after) * u(n + rows (before) + 1:end));
    s = squares (y, noise, before(r0, :), after(r1, :), scale);
    s.before = s.before - extra.before;
    gain(b) = mean (s.before(at) - s.after(at) + extra.after(at));
    room(b) = mean (s.before(at) - whole.floor(at));
  end
  chance = chiSquareTail (sum (whole.before ./ whole.floor), n);
  c.removable = mean (room > 0) >= 0.95 && chance < 0.05;
  c.closure = NaN;
  c.interval90 = [NaN, NaN];
  if c.removable
    c.closure = mean (whole.before - whole.after) / c.gap(1);
    ratio = sort (gain(room > 0) ./ room(room > 0));
    m = numel (ratio);
    c.interval90 = [ratio(max (1, round (0.05 * m))), ratio(ceil (0.95 * m))];
  end
end

function s = squares (y, noise, before, after, scale)
  s.before = (y - mean (before, 1)).^2 ./ scale.^2;
  s.after = (y - mean (after, 1)).^2 ./ scale.^2;
  s.floor = (noise + spread (before)) ./ scale.^2;
  s.floor1 = (noise + spread (after)) ./ scale.^2;
end

function v = spread (Z)
  v = zeros (1, columns (Z));
  if rows (Z) > 1
    v = var (Z, 0, 1) / rows (Z);
  end
end

%!test
%! % a cure that hits closes all but noise; a placebo closes nothing
%! randn ('twister', 1);
%! y = 10 + 0.1 * randn (1, 40);
%! off = 12 + 0.1 * randn (6, 40);
%! on = 10 + 0.1 * randn (6, 40);
%! c = closureOf (y, 0.01 * ones (1, 40), off, on, ones (1, 40));
%! assert (c.closure, 1, 0.02);
%! assert (c.interval90(1) > 0.9);
%! assert (c.floor, 0.108, 0.02);
%! c = closureOf (y, 0.01 * ones (1, 40), off, off, ones (1, 40));
%! assert (c.closure, 0);
%!test
%! % nothing to remove
%! randn ('twister', 2);
%! y = 10 + 0.1 * randn (1, 20);
%! on = 10 + 0.1 * randn (6, 20);
%! c = closureOf (y, 0.01 * ones (1, 20), on, on, ones (1, 20));
%! assert (c.removable, false);
%! assert (c.closure, NaN);
