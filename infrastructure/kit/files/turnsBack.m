% TURNSBACK  The place at which a curve turns back on itself.
%
% CALL: PLACE = turnsBack (X)
%       PLACE = turnsBack (X, LEAST)
%
%   X      n x 1 or 1 x n, places in the order in which they were passed
%   LEAST  steps that there must be to and fro (default: none, see below)
%   PLACE  the first place from which it goes back; NaN: nowhere
%
% Standing still is no turn, nor is what may be rounding or the noise of a
% coordinate: a way back counts above 1 % of the range, and above 0.1 % where it
% takes eight steps or more, which noise of that size does not make in one
% direction.

function place = turnsBack (x, least)
  x = x(isfinite (x));
  step = diff (x);
  place = NaN;
  if all (step >= 0) || all (step <= 0)
    return
  elseif nargin > 1
    place = turnAt (x, 0.01, least);
    return
  end
  place = turnAt (x, 0.01, 1);
  if isnan (place)
    place = turnAt (x, 0.001, 8);
  end
end

% Legs between places from which it goes back by more than a SHARE of the range;
% the first between two legs of LEAST steps.
function place = turnAt (x, share, least)
  enough = share * (max (x) - min (x));
  [ends, way, far] = deal (1, 0, 1);
  for i = 2:numel (x)
    onward = way * (x(i) - x(far));
    if way == 0 && abs (x(i) - x(1)) > enough
      [way, far] = deal (sign (x(i) - x(1)), i);
    elseif onward >= 0
      far = i;
    elseif onward < -enough
      ends(end + 1) = far;
      [way, far] = deal (-way, i);
    end
  end
  steps = diff ([ends, far]);
  turn = find (steps(1:end - 1) >= least & steps(2:end) >= least, 1);
  place = NaN;
  if ~isempty (turn)
    place = x(ends(turn + 1));
  end
end

%!assert (turnsBack ([0, 1, 2, 2, 3]), NaN)
%!assert (turnsBack ([3; 2; 2; 0]), NaN)
%!assert (turnsBack ([0, 1, 2, 1.5, 1]), 2)
%!assert (turnsBack ([3, 2, 1, 2, 3, 0]), 1)
%!assert (turnsBack ([0, 1, NaN, 2, 1.9]), 2)
%!assert (turnsBack (0.1), NaN)
%!assert (turnsBack (zeros (1, 0)), NaN)
%!test
%! % noise is no turn, also of many points; a stiff unloading is
%! x = (0:1999) / 2000;
%! rand ('twister', 1);
%! assert (turnsBack (x + 1e-7 * rand (size (x))), NaN);
%! assert (turnsBack (x + 4e-3 * rand (size (x))), NaN);
%! assert (turnsBack ([x, x(end) * (1 - 2e-4 * (1:20))]), x(end));
%! assert (turnsBack ([x, fliplr(x)] + 1e-3 * rand (1, 4000)), 1, 2e-3);
%!test
%! % trials, one after the other, and one line at the wrong place
%! assert (turnsBack ([1, 2, 3, 1, 2, 3], 2), NaN);
%! assert (turnsBack ([1, 2, 4, 3, 5], 2), NaN);
%! assert (turnsBack ([1, 2, 3, 2.5, 1.5], 2), 3);

% SPDX-License-Identifier: GPL-3.0-only
