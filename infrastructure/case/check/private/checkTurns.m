% CHECKTURNS  Finds measured curves that turn back: loading and unloading.
%
% CALL: P = checkTurns (LINES)
%
%   LINES  those of the tables, see readMeasured
%   P      1 x n faults, see checkFault
%
% Lines of one curve at the same place are repeated trials. Those of a way back
% would be averaged with those of the way there. Trials that stand one after the
% other jump back to their beginning in one step: that is no way back.

function p = checkTurns (lines)
  p = checkFault ();
  lines = lines(isfinite ([lines.at]));
  keys = arrayfun (@(o) sprintf ("%s\n%d\n%s\n%s\n%s", o.file, o.model, ...
                                 o.name, o.series, o.condition), lines, ...
                   'UniformOutput', false);
  [~, first, number] = unique (keys, 'first');
  [~, order] = sort (first);
  for k = order(:)'
    mine = lines(number == k);
    isNew = [true, diff([mine.at]) ~= 0];
    at = [mine(isNew).at];
    place = turnsBack (at, 2);
    if ~isnan (place)
      one = mine(find ([mine.at] == place, 1));
      p(end + 1) = checkFault ('measuredTurn', ...
                               sprintf ('%s, line %d, at', one.file, ...
                                        one.line), ...
                               ['the places of ', one.series, ' to go one ' ...
                                'way'], ...
                               sprintf ('a curve that turns back at %.6g', ...
                                        place), ...
                               ['Loading and unloading are two curves: ' ...
                                'give the way back another name in the ' ...
                                'column series, and let getResults return ' ...
                                'both. If the lines are only in another ' ...
                                'order, sort them by at.']);
    end
  end
end

%!function reasons = check (rows, head)
%!  file = tempname ();
%!  writeAtomic (file, [head, "\n", sprintf("%s\n", rows{:})]);
%!  p = checkTurns (readMeasured (file, {'Oedo'}));
%!  reasons = arrayfun (@(q) q.id(20:end), p, 'UniformOutput', false);
%!endfunction
%!function rows = places (at, series)
%!  rows = arrayfun (@(x) sprintf ('%s,%g,1', series, x), at, ...
%!                   'UniformOutput', false);
%!endfunction
%!shared head, turn
%! head = 'series,at,value';
%! turn = [0.25, 0.5, 0.75, 1, 0.85, 0.65];
%!assert (check (places (turn, 'p'), head), {'measuredTurn'})
%!assert (check (places (1 - turn, 'p'), head), {'measuredTurn'})
%!assert (isempty (check ([places(turn(1:4), 'p'), places(turn(5:6), 'q')], ...
%!                        head)))
%!test
%! % trials: point by point, curve by curve, of two conditions
%! for at = {[1, 1, 2, 2, 3, 3], [1, 2, 3, 1, 2, 3, 1, 2, 3], 2, ...
%!           [3, 2, 1, 3, 2], [1, 2, 3, 3, 1, 1, 2]}
%!   assert (isempty (check (places (at{1}, 'p'), head)));
%! end
%! both = [strcat(places ([1, 2, 3], 'p'), ',reference'), ...
%!         strcat(places ([3, 2, 1], 'p'), ',moist')];
%! assert (isempty (check (both, [head, ',condition'])));

% SPDX-License-Identifier: GPL-3.0-only
