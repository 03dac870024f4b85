% WITHDRIFTS  Adds to means what a drift leaves open of them.
%
% CALL: MEANS = withDrifts (MEANS, LINES, QUANTITIES, DRIFTS)
%
%   MEANS       of varianceComponents
%   LINES, QUANTITIES, DRIFTS  of withoutDrift
%   MEANS       the same with a column of days for each drift: by how much a mean
%               was read before or after the middle of the session times the
%               error of the slope, so that states in turn share it; and swept
%               (logical: a change that was read only before or only after the
%               reference, while values drift)
%
% What was read one way is as uncertain as the drift is large: that it goes on as a
% straight line is an assumption then. A mean is taken to have its lines with equal
% weights.

function means = withDrifts (means, lines, quantities, drifts)
  group = [quantities.group];
  for drift = drifts
    error_ = drift.sd;
    if ~isempty (drift.oneWay)
      error_ = hypot (error_, drift.slope);
    end
    for m = 1:numel (means)
      at = lines.mean == m;
      mine = at & lines.session == drift.session & isfinite (lines.order) & ...
             reshape (group(lines.quantity), [], 1) == drift.group;
      offset = 0;
      if any (mine)
        offset = sum (lines.order(mine) - drift.middle) / sum (at) * ...
                 quantities(lines.quantity(find (mine, 1))).size;
      end
      means(m).days(end + 1) = offset * error_;
      means(m).sd = hypot (means(m).sd, offset * error_);
      means(m).shared = hypot (means(m).shared, offset * error_);
      means(m).swept = means(m).swept || ismember (m, drift.oneWay);
    end
  end
end

%!test
%! % read in turn, both have next to nothing; one way, all of the drift between them
%! means = struct ('sd', {3, 3}, 'shared', 0, 'days', zeros (1, 0), 'swept', false);
%! lines = struct ('mean', [1; 2; 1; 2], 'quantity', ones (4, 1), 'session', ...
%!                 ones (4, 1), 'order', [1; 2; 3; 4]);
%! drift = struct ('session', 1, 'group', 7, 'slope', 4, 'sd', 0.1, 'middle', 2.5, ...
%!                 'oneWay', zeros (1, 0));
%! q = struct ('group', 7, 'size', 1);
%! in = withDrifts (means, lines, q, drift);
%! assert ({in.days}, {-0.05, 0.05}, 1e-12);
%! assert ([in.sd, in(1).shared], [hypot(3, 0.05) * [1, 1], 0.05], 1e-12);
%! assert (! any ([in.swept]));
%! lines.order = [1; 3; 2; 4];
%! drift.oneWay = 2;
%! in = withDrifts (means, lines, q, drift);
%! assert ({in.days}, {-hypot(4, 0.1), hypot(4, 0.1)}, 1e-12);
%! assert ([in.swept], [false, true]);

% SPDX-License-Identifier: GPL-3.0-only
