% CHECKUNITS  Gives what was measured the unit that the results of a run have.
%
% CALL: [LINES, P] = checkUnits (LINES, MODELS)
%
%   LINES   those of the tables, of readConditions; value, sd, sessionSd and an absolute
%           tol are converted to the unit of results.csv, and unit is that one
%           then; given is the unit of the table
%   MODELS  1 x M struct array, see checkFindModels
%   P       1 x n faults, see checkFault: units that no factor joins
%
% Where results.csv has no unit, or no line of a quantity one, the line stays as it is.
% The only unit that lines of a quantity have, in whatever condition, is that of all.

function [lines, p] = checkUnits (lines, models)
  p = checkFault ();
  lines = withUnitOfOthers (lines);
  given = {lines.unit};
  [lines.given] = given{:};
  has = find (~cellfun (@isempty, given) & [lines.model] > 0);
  keys = arrayfun (@(o) sprintf ("%s\n%d\n%s\n%s\n%s", o.file, o.model, ...
                                 o.name, o.series, o.unit), lines(has), ...
                   'UniformOutput', false);
  [~, first, number] = unique (keys, 'first');
  [~, order] = sort (first);
  info = arrayfun (@(m) checkResultInfo (m.folder), models, ...
                   'UniformOutput', false);
  for k = order(:)'
    mine = has(number == k);
    one = lines(mine(1));
    unit = unitIn (info{one.model}, one);
    factor = unitFactor (one.unit, unit);
    if isempty (unit) || factor > 0
      factor(isempty (unit)) = 1;
      unit = [unit, repmat(one.unit, 1, isempty (unit))];
      lines(mine) = inUnit (lines(mine), factor, unit);
    else
      p(end + 1) = checkFault ('measuredUnit', ...
                               sprintf ('%s, line %d, unit', one.file, ...
                                        one.line), ...
                               ['a unit that can be converted to ', ...
                                describeValue(unit), ', as results.csv of ', ...
                                models(one.model).name, ' has it'], ...
                               describeValue (one.unit), ...
                               ['Correct the unit in one of the two, or ' ...
                                'convert the value and its sd.']);
    end
  end
end

function lines = withUnitOfOthers (lines)
  keys = arrayfun (@(o) sprintf ("%d\n%s\n%s", o.model, o.name, o.series), lines, ...
                   'UniformOutput', false);
  [~, ~, number] = unique (keys);
  hasValue = isfinite ([lines.value]);
  for k = 1:max ([number(:); 0])
    mine = find (number(:)' == k & hasValue);
    units = setdiff ({lines(mine).unit}, {''});
    if isscalar (units)
      [lines(mine).unit] = deal (units{1});
    end
  end
end

% '' where nothing says it; the one that the line has where there are several.
function unit = unitIn (info, one)
  isIt = strcmp ({info.name}, one.name) | ...
         (~isempty (one.series) & (strcmp ({info.name}, one.series) | ...
                                   strcmp ({info.series}, one.series)));
  units = setdiff ({info(isIt).unit}, {''});
  units = [units(strcmp (units, one.unit)), units, {''}];
  unit = units{1};
end

function lines = inUnit (lines, factor, unit)
  [lines.unit] = deal (unit);
  for k = 1:numel (lines) * (factor ~= 1)
    lines(k).value = lines(k).value * factor;
    lines(k).sd = lines(k).sd * factor;
    lines(k).sessionSd = givenField (lines(k), 'sessionSd', NaN) * factor;
    if lines(k).isAbsolute
      lines(k).tol = lines(k).tol * factor;
    end
  end
end

%!function [lines, reasons] = check (text, table)
%!  folder = emptyFolder ();
%!  writeAtomic (fullfile (folder, 'results.csv'), table);
%!  file = fullfile (folder, 'measured.csv');
%!  writeAtomic (file, text);
%!  model = struct ('name', 'Toy', 'folder', folder);
%!  [lines, p] = checkUnits (readMeasured (file, {'Toy'}), model);
%!  reasons = arrayfun (@(q) q.id(20:end), p, 'UniformOutput', false);
%!endfunction
%!shared table, head
%! table = ["name,kind,unit,series,at,text\ntop,mass,kg,,,t\n", ...
%!          "w,mass,%,,,t\nfree,,,,,t\n"];
%! head = "name,value,unit,series,at,sd,tol\n";
%!test
%! [lines, reasons] = check ([head, "top,1,kg,,,,\ntop,2,,,,,\n", ...
%!                            "free,1,g,,,,\n,1,%,w,1,,\n"], table);
%! assert (isempty (reasons));
%! assert ([lines.value], [1, 2, 1, 1]);
%! % one unit of a quantity is that of all its lines
%! assert ({lines.unit}, {'kg', 'kg', 'g', '%'});
%! % value, sd, sessionSd and an absolute tolerance; a relative one stays
%! [lines, reasons] = check ([head, "top,13.5,g,,,2,1 abs\n", ...
%!                            "top,0.1,t,,,,2%\n"], table);
%! assert (isempty (reasons));
%! assert ([lines.value; lines.sd; lines.tol], ...
%!         [0.0135, 100; 0.002, 0; 0.001, 0.02], 1e-12);
%! assert ({lines.unit, lines.given}, {'kg', 'kg', 'g', 't'});
%! % a unit that is wrong all along a curve is one fault; one not known
%! [~, reasons] = check ([head, ",1,g,w,1,,\n,2,g,w,2,,\n"], table);
%! assert (reasons, {'measuredUnit'});
%! [~, reasons] = check ([head, "top,1,pieces,,,,\n"], table);
%! assert (reasons, {'measuredUnit'});

% SPDX-License-Identifier: GPL-3.0-only
