% WITHOUTDRIFT  Takes out what drifts with the order of trials within a session.
%
% CALL: [LINES, DRIFTS] = withoutDrift (LINES, QUANTITIES)
%
%   LINES       of readingLines, with order (n x 1; NaN: not given)
%   QUANTITIES  1 x Q struct: group, size (a drift is one of all quantities of a
%               group, in each its slope times size)
%   DRIFTS      1 x D struct, of each session and group that drifts: session,
%               group, slope (per order), sd (its 68 % half-width), p (Student's t,
%               two-sided), middle (order at which values hold), means (of LINES
%               in it), oneWay (those of a change that was read only before or
%               only after the reference)
%
% A drift (a rig that warms, grains that wear) is one of all states and settings of
% a session. A straight line about the mean of each state and quantity tells it;
% below p = 0.01, shared among all that could drift (Holm 1979: what drifts passes its
% share on), it is taken out.
%
% See also: withDrifts

function [lines, drifts] = withoutDrift (lines, quantities)
  drifts = struct ('session', {}, 'group', {}, 'slope', {}, 'sd', {}, 'p', {}, ...
                   'middle', {}, 'means', {}, 'oneWay', {});
  isOrdered = isfinite (lines.order) & isnan (lines.variance);
  group = reshape ([quantities.group], [], 1)(lines.quantity);
  kinds = unique ([lines.session(isOrdered), group(isOrdered)], 'rows');
  for k = 1:rows (kinds)
    at = find (isOrdered & lines.session == kinds(k, 1) & group == kinds(k, 2));
    [slope, sd, p] = slopeOf (lines, quantities, at);
    inSession = isOrdered & lines.session == kinds(k, 1);
    drifts(end + 1) = struct ('session', kinds(k, 1), 'group', kinds(k, 2), ...
                              'slope', slope, 'sd', sd, 'p', p, 'middle', ...
                              mean (lines.order(inSession)), 'means', ...
                              unique (lines.mean(at))', 'oneWay', ...
                              oneWay (lines, at));
  end
  p = sort ([drifts.p]);
  level = 0.01 ./ max (sum (isfinite (p)) - (0:numel (p) - 1), 1);
  drifts = drifts([drifts.p] <= max ([p(cumprod (p < level) > 0), -1]));
  for drift = drifts
    at = find (isOrdered & lines.session == drift.session & group == drift.group);
    size = reshape ([quantities.size], [], 1)(lines.quantity(at));
    lines.value(at) = lines.value(at) - ...
                      drift.slope * size .* (lines.order(at) - drift.middle);
  end
end

% P is NaN where too few lines could tell a slope.
function [slope, sd, p] = slopeOf (lines, quantities, at)
  size = reshape ([quantities.size], [], 1)(lines.quantity(at));
  weight = lines.repeats(at);
  [cells, ~, of] = unique ([lines.mean(at), lines.quantity(at)], 'rows');
  x = aboutMeans (lines.order(at), weight, of);
  y = aboutMeans (lines.value(at) ./ size, weight, of);
  df = numel (at) - rows (cells) - 1;
  [slope, sd, p] = deal (0, 0, NaN);
  spread = sum (weight .* x.^2);
  if df < 2 || ~(spread > 0) || ~all (isfinite (y))
    return
  end
  slope = sum (weight .* x .* y) / spread;
  variance = sum (weight .* (y - slope * x).^2) / df / spread;
  p = betainc (variance * df / (variance * df + slope^2 + realmin), df / 2, 0.5);
  % what rounding leaves of a straight line is no scatter
  sd = -studentQuantile (0.1587, df) * sqrt (variance) * (variance > 1e-18 * slope^2);
end

function v = aboutMeans (v, weight, of)
  means = accumarray (of, weight .* v) ./ accumarray (of, weight);
  v = v - means(of);
end

% Means of a change of which all lines come before, or after, those of the reference
% of their quantity.
function means = oneWay (lines, at)
  means = zeros (1, 0);
  for m = unique (lines.mean(at(lines.changed(at))))'
    now = at(lines.mean(at) == m);
    before = at(~lines.changed(at) & lines.quantity(at) == lines.quantity(now(1)));
    [now, before] = deal (lines.order(now), lines.order(before));
    if ~isempty (before) && (min (now) > max (before) || max (now) < min (before))
      means(end + 1) = m;
    end
  end
end

%!function lines = of (values, order, state)
%!  n = numel (values);
%!  lines = struct ('value', values(:), 'mean', state(:), 'quantity', ones (n, 1), ...
%!                  'session', ones (n, 1), 'repeats', ones (n, 1), 'variance', ...
%!                  NaN (n, 1), 'changed', state(:) > 1, 'order', order(:));
%!endfunction
%!shared one, values
%! one = struct ('group', 1, 'size', 1);
%! values = 10 + 0.5 * (1:8) + 0.01 * [1, -1, 0, 1, 0, -1, 1, -1];
%!test
%! % a line is found and taken out, with what it leaves open; states in turn are
%! % not read one way
%! [lines, drift] = withoutDrift (of (values, 1:8, [1, 2, 1, 2, 1, 2, 1, 2]), one);
%! assert ([drift.slope, drift.middle], [0.5, 4.5], 0.01);
%! assert (drift.p < 1e-6 && drift.sd > 0 && isempty (drift.oneWay));
%! assert (lines.value, 12.25 * ones (8, 1), 0.1);
%!test
%! % the change after the reference alone; no order, no drift; a step is none
%! [~, drift] = withoutDrift (of (values, 1:8, [1, 1, 1, 1, 2, 2, 2, 2]), one);
%! assert (drift.oneWay, 2);
%! lines = of (values, NaN (1, 8), [1, 1, 1, 1, 2, 2, 2, 2]);
%! [same, drift] = withoutDrift (lines, one);
%! assert ({same, numel(drift)}, {lines, 0});
%! [~, drift] = withoutDrift (of ([1, 2, 2, 1, 9, 8, 8, 9], 1:8, ...
%!                                [1, 1, 1, 1, 2, 2, 2, 2]), one);
%! assert (isempty (drift));
%! % three surely drift, the fourth (p = 0.0046) by the share that they pass on
%! last = [10, 11, 10, 11, 11, 12, 12, 12];
%! four = of ([values, values, values, last], repmat (1:8, 1, 4), kron (1:4, ones (1, 8)));
%! four.quantity = four.mean;
%! four.changed(:) = false;
%! [~, drift] = withoutDrift (four, struct ('group', {1, 2, 3, 4}, 'size', 1));
%! assert ([drift.group], 1:4);
%! % of readings that lie on a line no scatter is known
%! [lines, drift] = withoutDrift (of (31 + 0.1 * (1:6), 1:6, [1, 2, 1, 2, 1, 2]), one);
%! assert ({drift.slope, drift.sd, lines.value}, {0.1, 0, 31.35 * ones(6, 1)}, 1e-12);
%!test
%! % points of a curve drift by the same share, also one that was read once
%! lines = of ([10, 20, 30, 10.1, 20.2, 10.2, 20.4], [0, 0, 2, 1, 1, 2, 2], ...
%!             ones (1, 7));
%! [lines.mean, lines.quantity] = deal ([1; 2; 3; 1; 2; 1; 2]);
%! curve = struct ('group', 1, 'size', {10.1, 20.2, 30});
%! [lines, drift] = withoutDrift (lines, curve);
%! assert (drift.slope, 0.0099, 1e-4);
%! assert (lines.value(3), 30 * (1 - 0.0099 * (2 - 8 / 7)), 1e-2);

% SPDX-License-Identifier: GPL-3.0-only
