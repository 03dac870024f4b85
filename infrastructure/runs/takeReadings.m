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
  k = 0;
  while isempty (fault) && k < numel (readings)
    k = k + 1;
    [row(k), fault] = readOne (items, readings(k), info);
    if isempty (fault) && isSpread (items, readings, k, info)
      fault = sprintf (['%s must be a curve (n x 2: place, value), since ' ...
                        'measured.csv asks for its value at %g; the run ' ...
                        'gave one number'], readings(k).result, ...
                       readings(k).at);
    end
  end
end

% A finite number that stands for the whole of a curve. A result with a name of
% its own, or with its place in results.csv, belongs to one place.
function yes = isSpread (items, readings, k, info)
  r = readings(k);
  found = givenField (items, r.result, givenField (items, r.series, []));
  hasPlace = ~isempty (info) && ...
             any (strcmp ({info.name}, r.result) & [info.at] == r.at);
  isOwn = isfield (items, r.result) && ~strcmp (r.result, r.series) && ...
          sum (strcmp ({readings.result}, r.result)) == 1;
  yes = ~isnan (r.at) && isscalar (found) && isfinite (found) && ...
        ~hasPlace && ~isOwn;
end

function [value, fault] = readOne (items, r, info)
  fault = '';
  found = givenField (items, r.result, givenField (items, r.series, []));
  if isempty (found)
    found = seriesOf (items, r.series, info);
  end
  value = found;
  if isempty (found)
    value = NaN;
    fault = sprintf (['getResults must return %s, named by a field of ' ...
                      'its struct or by results.csv'], r.result);
  elseif ~isscalar (found)
    [value, fault] = pointOf (found, r);
  end
end

% One struct, whatever the form. Names of results need not be identifiers.
function [items, fault] = itemsOf (results, readings, info)
  fault = '';
  items = results;
  if ~isstruct (results) || ~isscalar (results)
    [items, fault] = byOrder (results, readings, info);
  end
  isGood = @(x) (isnumeric (x) || islogical (x)) && isreal (x) && ...
                (isscalar (x) || columns (x) == 2);
  bad = find (~structfun (isGood, items), 1);
  if ~isempty (bad)
    fault = sprintf (['%s must be a real number or a curve (n x 2: ' ...
                      'place, value)'], fieldnames (items){bad});
  end
end

% One curve alone, or all results in the order of results.csv.
function [items, fault] = byOrder (results, readings, info)
  items = struct ();
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
    fault = sprintf (['getResults returned %d results, results.csv ' ...
                      'names %d'], numel (results), numel (names));
    return
  end
  for k = 1:numel (names)
    items.(names{k}) = results{k};
  end
end

function curve = seriesOf (items, series, info)
  curve = [];
  if isempty (series) || isempty (info)
    return
  end
  for r = info(strcmp ({info.series}, series))
    if isfield (items, r.name) && isscalar (items.(r.name))
      curve(end + 1, :) = [r.at, items.(r.name)];
    end
  end
end

function [value, fault] = pointOf (curve, r)
  fault = '';
  value = NaN;
  if isnan (r.at)
    fault = sprintf (['%s is a curve: measured.csv must say where on it ' ...
                      '(series, at)'], r.result);
    return
  end
  curve = double (curve(all (isfinite (curve), 2), :));
  [x, last] = unique (curve(:, 1), 'last');
  y = curve(last, 2);
  near = find (abs (x - r.at) <= 1e-9 * max (abs ([x; r.at])), 1);
  if ~isempty (near)
    value = y(near);
  elseif ~isempty (x) && (r.at < x(1) || r.at > x(end))
    fault = sprintf ('%s at %g lies beyond the curve (%g to %g)', r.result, ...
                     r.at, x(1), x(end));
  elseif numel (x) > 1
    value = interp1 (x, y, r.at);
  end
end

%!shared r
%! r = struct ('result', {'w', 'w', 'mass'}, 'series', {'w', 'w', ''}, ...
%!             'at', {1.5, 3, NaN});
%!test
%! s = struct ('mass', 7, 'w', [3, 9; 1, 1; 2, 4]);
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
%! % one curve alone
%! assert (takeReadings ([1, 1; 2, 4; 3, 9], r(1:2), []), [2.5, 9]);
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
