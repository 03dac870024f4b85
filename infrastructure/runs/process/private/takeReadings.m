% TAKEREADINGS  Takes from the results of a run what was measured.
%
% CALL: [ROW, FAULT] = takeReadings (RESULTS, READINGS, INFO)
%
%   RESULTS   what getResults returned: a scalar struct whose fields are numbers
%             or curves; or a cell of numbers and curves (namedResults), or a
%             row of numbers, in the order of results.csv; or one curve. A curve
%             is n x 2: place and value, on a grid of the run's own
%   READINGS  1 x m struct with result (name), series (name of the curve, '':
%             none) and at (place on it)
%   INFO      see resultInfo; [] without results.csv
%   ROW       1 x m; a curve is interpolated to the place linearly, NaN beyond
%             its ends, which is a fault
%   FAULT     '' or what is wrong with RESULTS
%
% A reading is the result of its name, else a point of the curve with the name
% of its series, else a point between the single results that results.csv puts
% on that series. One number is no curve: it would count at every place.

function [row, fault] = takeReadings (results, readings, info)
  row = NaN (1, numel (readings));
  [items, fault] = itemsOf (results, readings, info);
  [~, first, which] = unique (strcat ({readings.result}, "\n", ...
                                      {readings.series}));
  k = 0;
  while isempty (fault) && k < numel (first)
    k = k + 1;
    mine = find (which == k);
    [row(mine), fault] = readMany (items, readings(mine), info);
  end
end

% READINGS of one result or curve.
function [row, fault] = readMany (items, readings, info)
  r = readings(1);
  [row, fault] = deal (NaN, '');
  found = itemOf (items, r.result);
  if isempty (found)
    found = itemOf (items, r.series);
  end
  isSeries = isempty (found);
  if isSeries
    found = seriesOf (items, r.series, info);
  end
  if isempty (found)
    fault = sprintf (['getResults must return %s, named by a field of ' ...
                      'its struct or by results.csv'], r.result);
  elseif isscalar (found)
    row = found;
    at = unplaced (found, items, readings, info);
    if ~isempty (at)
      fault = sprintf (['%s must be a curve (n x 2: place, value), since ' ...
                        'measured.csv asks for its value at %g; the run ' ...
                        'gave one number'], r.result, at(1));
    end
  else
    found = double (found(all (isfinite (found), 2), :));
    if ~isSeries
      fault = faultOfTurn (found(:, 1), r);
    end
    [row, fault] = pointsOf (found, readings, fault);
  end
end

% Places for which the finite number FOUND is taken, but which it does not belong
% to. A result with a name of its own, or with its place in results.csv, belongs
% to one place.
function at = unplaced (found, items, readings, info)
  r = readings(1);
  at = [readings.at];
  at = at(~isnan (at));
  if ~isempty (info)
    at = setdiff (at, [info(strcmp({info.name}, r.result)).at]);
  end
  isOwn = ~isempty (itemOf (items, r.result)) && ...
          ~strcmp (r.result, r.series) && isscalar (readings);
  if isOwn || ~isfinite (found)
    at = [];
  end
end

function fault = faultOfTurn (x, r)
  fault = '';
  place = turnsBack (x);
  if ~isnan (place)
    fault = sprintf (['the curve %s turns back at %.6g: return loading and ' ...
                      'unloading as two curves (docs/inputs.md, Curves ' ...
                      'that turn back)'], r.result, place);
  end
end

% Names and values, whatever the form.
function [items, fault] = itemsOf (results, readings, info)
  fault = '';
  if isstruct (results) && isscalar (results)
    items = struct ('names', {fieldnames(results)'}, ...
                    'values', {struct2cell(results)'});
  else
    [items, fault] = byOrder (results, readings, info);
  end
  isGood = @(x) (isnumeric (x) || islogical (x)) && isreal (x) && ...
                (isscalar (x) || columns (x) == 2);
  items.values(cellfun (@(x) isequal (x, []), items.values)) = NaN;
  bad = find (~cellfun (isGood, items.values), 1);
  if ~isempty (bad)
    fault = sprintf (['%s must be a real number or a curve (n x 2: ' ...
                      'place, value)'], items.names{bad});
  end
end

% One curve alone, or all results in the order of results.csv.
function [items, fault] = byOrder (results, readings, info)
  fault = '';
  names = {};
  if ~isempty (info)
    names = {info.name};
  end
  if isnumeric (results) && columns (results) == 2 && rows (results) > 1
    results = {results};
    names = unique ({readings.series});
    names = names(~cellfun (@isempty, names));
  elseif ~iscell (results)
    results = num2cell (results);
  end
  if numel (names) ~= numel (results)
    fault = sprintf ('getResults returned %s, results.csv names %d', ...
                     countText (numel (results), 'result'), numel (names));
    [names, results] = deal ({});
  end
  items = struct ('names', {names}, 'values', {results(:)'});
end

function value = itemOf (items, name)
  value = [];
  k = find (strcmp (items.names, name), 1);
  if ~isempty (k)
    value = items.values{k};
  end
end

function curve = seriesOf (items, series, info)
  curve = [];
  if isempty (series) || isempty (info)
    return
  end
  for r = info(strcmp ({info.series}, series))
    value = itemOf (items, r.name);
    if isscalar (value)
      curve(end + 1, :) = [r.at, value];
    end
  end
end

function [row, fault] = pointsOf (curve, readings, fault)
  at = [readings.at];
  row = NaN (size (at));
  if any (isnan (at))
    fault = sprintf (['%s is a curve: measured.csv must say where on it ' ...
                      '(series, at)'], readings(1).result);
  end
  [x, last] = unique (curve(:, 1), 'last');
  y = curve(last, 2);
  if ~isempty (fault) || isempty (x)
    return
  end
  % what is next to a point but for rounding is that point
  for step = [0, 1]
    near = min (max (lookup (x, at) + step, 1), numel (x));
    isNear = abs (x(near)(:)' - at) <= 1e-9 * max (max (abs (x)), abs (at));
    at(isNear) = x(near(isNear));
  end
  beyond = find (at < x(1) | at > x(end), 1);
  if ~isempty (beyond)
    fault = sprintf ('%s at %g lies beyond the curve (%g to %g)', ...
                     readings(1).result, at(beyond), x(1), x(end));
  end
  if isscalar (x)
    row(at == x) = y;
  else
    row = interp1 (x, y, at, 'linear', NaN);
  end
end

%!shared r
%! r = struct ('result', {'w', 'w', 'mass'}, 'series', {'w', 'w', ''}, ...
%!             'at', {1.5, 3, NaN});
%!test
%! s = struct ('mass', 7, 'w', [3, 9; 2, 4; 1, 1]);
%! [row, fault] = takeReadings (s, r, []);
%! assert (row, [2.5, 9, 7]);
%! assert (fault, '');
%! % beyond the end of the curve there is nothing
%! s.w(1, :) = [];
%! [row, fault] = takeReadings (s, r([1, 3, 2]), []);
%! assert (row, [2.5, 7, NaN]);
%! assert (fault, 'w at 3 lies beyond the curve (1 to 2)');
%!test
%! % a cell in the order of results.csv, and single results on a series
%! info = struct ('name', {'mass', 'run 1', 'run 2'}, ...
%!                'series', {'', 'w', 'w'}, 'at', {NaN, 1, 3});
%! assert (takeReadings ({7, 2, 4}, r, info), [2.5, 4, 7]);
%! assert (takeReadings ([7, 2, 4], r, info), [2.5, 4, 7]);
%! byName = struct ('result', 'run 2', 'series', 'w', 'at', 3);
%! assert (takeReadings ([7, 2, 4], byName, info), 4);
%! [~, fault] = takeReadings ({7, 2}, r, info);
%! assert (fault, 'getResults returned 2 results, results.csv names 3');
%! % one curve alone; loading and unloading are two
%! assert (takeReadings ([1, 1; 2, 4; 3, 9], r(1:2), []), [2.5, 9]);
%! [row, fault] = takeReadings ([1, 1; 2, 4; 3, 9; 2, 1], r(1:2), []);
%! assert (row, [NaN, NaN]);
%! assert (strncmp (fault, 'the curve w turns back at 3: return', 34));
%! % one place twice, as a solver writes it that prints the last step again
%! assert (takeReadings ([1, 1; 2, 4; 2, 4; 3, 9], r(1:2), []), [2.5, 9]);
%!test
%! curve = [1, 2; 4, 3];
%! for bad = {struct('mass', 7), 'must return w'; ...
%!            struct('mass', 'x', 'w', 1), 'mass must be a real number'; ...
%!            struct('mass', 7, 'w', 5), 'w must be a curve'; ...
%!            struct('mass', curve, 'w', curve), 'must say where'}'
%!   [~, fault] = takeReadings (bad{1}, r, []);
%!   assert (! isempty (strfind (fault, bad{2})), fault);
%! end
%!test
%! % one number for a curve: by the name of the result, of its series, shared;
%! % NaN is no result, and a number with its place in results.csv is one
%! at = @(result, series, places) struct ('result', result, 'series', ...
%!                                        series, 'at', num2cell (places));
%! isFault = @(items, r, info) ~isempty (nthargout (2, @takeReadings, items, ...
%!                                                  r, info));
%! assert (isFault (struct ('w', 5), at ('w', 'w', 2), []));
%! assert (isFault (struct ('w', 5), at ('v', 'w', 2), []));
%! assert (isFault (struct ('v', 5), at ('v', 'w', [1, 2]), []));
%! assert (isFault ({5}, at ('w', 'w', [1, 2]), ...
%!                  struct ('name', 'w', 'series', '', 'at', NaN)));
%! assert (! isFault (struct ('v', 5), at ('v', 'w', 2), []));
%! assert (! isFault (struct ('w', NaN), at ('w', 'w', [1, 2]), []));
%! assert (! isFault (struct ('w', 5), at ('w', '', NaN), []));
%! info = struct ('name', 'w', 'series', 'w', 'at', 2);
%! assert (! isFault (struct ('w', 5), at ('w', 'w', 2), info));
%! assert (isFault (struct ('w', 5), at ('w', 'w', 3), info));

% SPDX-License-Identifier: GPL-3.0-only
