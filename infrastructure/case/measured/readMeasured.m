% READMEASURED  Reads a table of measured values, as measured.csv.
%
% CALL: [LIST, FAULTS, HEADER] = readMeasured (FILE, MODELS, ALONE, SHOWN)
%
%   FILE      path of the table, in any form that readCsvTable takes
%   MODELS    1 x M cell, names of the models; '' where a name is not usable
%   ALONE     number of the model of a line that names none (0: it must name
%             one; default 1 where there is one model, else 0)
%   SHOWN     name of the table in FAULTS (text, default measured.csv)
%   LIST      1 x n struct, one element a line: line (number in the file),
%             file (SHOWN), model (number), name, series, unit (texts), at
%             (NaN: none), value (NaN: not measured yet), sd (0: not given),
%             repeats (trials that the value is the mean of; Inf: sd holds
%             their scatter; NaN: not given), role ('': not given), tol (NaN:
%             not given), isAbsolute (logical: tol has the unit of the value),
%             saysTol (logical: there is one, good or bad), condition,
%             session, block ('': not given), sessionSd, order (of the trial, or
%             its time; NaN: not given); [] where the table as a whole is no use
%   FAULTS    1 x p faults, see checkFault
%   HEADER    1 x m cell, names of the columns
%
% Columns, in any order: name or series, and value, are needed; model, where
% there are several. tol is a share of the value (0.02, 2%, +-2 %) or absolute
% (0.5 abs, 1 deg with a unit of the value); of the value 0 it is always absolute.
% sd may be a share (2%), and a value may have its unit behind it. Further forms
% of the table: see measuredColumns.

function [list, p, header] = readMeasured (file, models, alone, shown)
  if nargin < 3
    alone = double (isscalar (models));
  end
  if nargin < 4
    shown = 'measured.csv';
  end
  [list, header] = deal ([], {});
  try
    [header, cells, lines] = readCsvTable (file);
  catch err
    cure = 'Save it as CSV with one header line.';
    isClear = ~strcmp (err.identifier, 'DEcalioc:readCsvTable:unclearPoint');
    p = checkFault ('measuredTable', shown, ...
                    'a table with a header line and clear numbers', ...
                    ['one that cannot be read: ', err.message], ...
                    repmat (cure, 1, isClear));
    return
  end
  known = {'model', 'name', 'value', 'sd', 'unit', 'repeats', 'role', ...
           'series', 'at', 'tol', 'condition', 'session', 'sessionSd', ...
           'block', 'order'};
  if ~isempty (cells)
    [header, cells, lines] = measuredColumns (header, cells, lines, known);
  end
  p = checkHeader (header, known, rows (cells), shown);
  if ~isempty (p)
    return
  end
  [~, column] = ismember (header, known);
  texts = repmat ({''}, rows (cells), numel (known));
  texts(:, column) = cells;
  list = cell2struct (texts, known, 2)';
  numbers = num2cell (lines);
  [list.line] = numbers{:};
  [list.file] = deal (shown);
  [list, faults] = arrayfun (@(row) readRow (row, models, alone), list, ...
                             'UniformOutput', false);
  [list, p] = deal ([list{:}], [p, faults{:}]);
end

function p = checkHeader (header, known, n, shown)
  p = checkFault ();
  cure = ['The columns are ', strjoin(known, ', '), '; one for people is ' ...
          'called remark.'];
  words = ['^(std|stdev|var|variance|se|s\.?e\.?m\.?|standard|\d ?sd|ci ?\d*|', ...
           'err(or)?|uncertainty)\>'];
  isSpread = ~cellfun (@isempty, regexpi (header, words)) & ~ismember (header, known);
  if any (isSpread)
    cure = ['sd is the standard uncertainty of the value: std / sqrt (n) of ' ...
            'the mean of n trials, a standard error as it is, the root of a ' ...
            'variance, half of 2 sd or of the half width of a 95 % interval. ', cure];
  end
  if ~any (ismember (header, known))
    p = checkFault ('measuredColumn', shown, ...
                    'a first line with the names of the columns', ...
                    strjoin (header, ', '), cure);
    return
  end
  for k = find (~ismember (header, known))
    p(end + 1) = checkFault ('measuredColumn', shown, ...
                             'columns that are known', ...
                             describeValue (header{k}), ...
                             strtrim ([checkNearest(header{k}, ...
                                                    known(~isSpread(k), :)), ...
                                       ' ', cure]));
  end
  [~, once] = unique (header);
  for k = setdiff (1:numel (header), once)
    p(end + 1) = checkFault ('measuredColumn', shown, ...
                             'each column once', ...
                             [describeValue(header{k}), ' twice'], cure);
  end
  if ~any (strcmp (header, 'value')) || ...
     ~any (ismember (header, {'name', 'series'}))
    p(end + 1) = checkFault ('measuredColumn', shown, ...
                             'the columns name (or series) and value', ...
                             strjoin (header, ', '), cure);
  end
  if n == 0
    p(end + 1) = checkFault ('measuredTable', shown, ...
                             'at least one measured value', ...
                             'a header alone', cure);
  end
end

% ROW comes as texts.
function [row, p] = readRow (row, models, alone)
  where = sprintf ('%s, line %d', row.file, row.line);
  [row.model, p] = modelOf (row.model, models, alone, where);
  rules = {'value', NaN, @isfinite, ...
           'a number, or nothing: not measured yet'; ...
           'sd', 0, @(v) v >= 0 & isfinite (v), 'a number from 0'; ...
           'repeats', NaN, @(v) v > 0, 'a number above 0, or Inf'; ...
           'sessionSd', NaN, @(v) v >= 0 & isfinite (v), 'a number from 0'; ...
           'order', NaN, @isfinite, 'the number of the trial, or its time'; ...
           'at', NaN, @isfinite, 'a number'};
  places = checkPlace (row, where);
  row.role = lower (row.role);
  row = withUnits (row);
  row.order = hoursOf (row.order);
  for rule = rules'
    [row.(rule{1}), q] = numberOf (row.(rule{1}), rule, where);
    p = [p, q];
  end
  if ~any (strcmp (row.role, {'', 'calibrate', 'holdout'}))
    p(end + 1) = checkFault ('measuredRole', [where, ', role'], ...
                             'calibrate or holdout', describeValue (row.role), ...
                             'Leave it empty for calibrate.');
  end
  row.saysTol = ~isempty (row.tol);
  [row.tol, row.isAbsolute, q] = toleranceOf (row, where);
  p = [p, q, places];
end

function [k, p] = modelOf (name, models, alone, where)
  p = checkFault ();
  k = find (strcmp (name, models), 1);
  if isempty (name) && alone > 0
    k = alone;
  elseif isempty (k) && ~isempty (models)
    p = checkFault ('measuredModel', [where, ', model'], ...
                    ['one of ', strjoin(models, ', ')], describeValue (name), ...
                    strtrim ([checkNearest(name, models), ...
                              ' Write a model of Input.model.']));
  end
  if isempty (k)
    k = 0;
  end
end

% The unit behind value, and that or the % behind sd and sessionSd.
function row = withUnits (row)
  form = '^([-+.\d]+(?:[eE][-+]?\d+)?)\s*([^-+\s.,\d].*)$';
  words = regexp (row.value, form, 'tokens', 'once');
  if ~isempty (words)
    factor = unitFactor (words{2}, row.unit);
    if isempty (row.unit) && ~isnan (unitFactor (words{2}, 'm'))
      [row.value, row.unit] = words{:};
    elseif isequal (factor, 1)
      row.value = words{1};
    end
  end
  for name = {'sd', 'sessionSd'}
    words = regexp (row.(name{1}), form, 'tokens', 'once');
    if isempty (words)
      continue
    elseif strcmp (words{2}, '%') && ~strcmp (row.unit, '%')
      share = abs (str2double (row.value)) / 100;
      row.(name{1}) = exactNumber (str2double (words{1}) * share);
    elseif unitFactor (words{2}, row.unit) > 0
      factor = unitFactor (words{2}, row.unit);
      row.(name{1}) = exactNumber (factor * str2double (words{1}));
    end
  end
end

% Of a time of the day, 9.5 of '09:30'; others stay.
function text = hoursOf (text)
  parts = str2double (strsplit (text, ':'));
  n = numel (parts);
  if n > 1 && n < 4 && all (parts >= 0 & parts < 60)
    text = exactNumber (sum (parts .* 60.^(0:-1:1 - n)));
  end
end

function [value, p] = numberOf (text, rule, where)
  [name, value, isGood, expected] = rule{:};
  p = checkFault ();
  if isempty (text)
    return
  end
  number = str2double (text);
  % str2double takes a comma for a separator of thousands
  if ~any (text == ',') && isreal (number) && isGood (number)
    value = number;
  else
    p = checkFault ('measuredNumber', [where, ', ', name], expected, ...
                    describeValue (text), cureOf (text, name));
  end
end

function cure = cureOf (text, name)
  cure = 'Leave it empty where no number was found.';
  if any (text == ',')
    cure = 'Decimal commas need semicolons between the columns.';
  elseif ~isempty (regexp (text, [char([194, 177]), '|\+/?-'], 'once'))
    cure = ['Write the mean here and its standard uncertainty in the column ' ...
            'sd.'];
  elseif any (strcmp (name, {'value', 'sd'})) && ...
      ~isempty (regexp (text, '^[-+.\d]+\s*[A-Za-z%]', 'once'))
    cure = 'Write its unit into the column unit.';
  elseif strcmp (name, 'order')
    cure = 'Count the trials of a session, or write a time of the day such as 09:30.';
  elseif strcmp (name, 'value') && ~isempty (regexp (text, '^[<A-Za-z]', 'once'))
    cure = 'If nothing flowed or moved, write 0, and a tol like 0.1 abs; else leave it empty.';
  end
end

function [tol, isAbsolute, p] = toleranceOf (row, where)
  p = checkFault ();
  [text, value] = deal (row.tol, row.value);
  isAbsolute = value == 0;
  tol = NaN;
  if isempty (text)
    return
  end
  plain = regexprep (text, ['^(\+/?-|', char([194, 177]), ')\s*'], '');
  words = regexp (plain, ['^([-+.,\d]+(?:[eE][-+]?\d+)?)\s*' ...
                          '(%|abs|[^\s\d%.,][^\s%]*|)$'], 'tokens', 'once');
  if ~isempty (words)
    [factor, hasUnit] = factorOf (words{2}, row.unit);
    tol = factor * str2double (strrep (words{1}, ',', '.'));
    isAbsolute = isAbsolute || hasUnit;
  end
  isPercent = ~isempty (words) && strcmp (words{2}, '%');
  if isPercent
    tol = tol / 100;
  end
  isGood = tol > 0 && isfinite (tol) && (isAbsolute || tol < 1) && ...
           ~(isPercent && value == 0);
  if ~isGood
    p = checkFault ('measuredTol', [where, ', tol'], ...
                    ['a share of the value between 0 and 1 (0.02 or 2%), ' ...
                     'or 0.5 abs (0.5 deg) in the unit of the value'], ...
                    describeValue (text), cureOfTol (tol, value));
    tol = NaN;
  end
end

function cure = cureOfTol (tol, value)
  cure = 'Write 2%, for instance.';
  if value == 0
    cure = 'The tolerance of the value 0 is absolute.';
  elseif tol == 0
    cure = 'Runs scatter, so with a tolerance of 0 no values would ever do.';
  end
end

% By what a tolerance with WORD behind it is multiplied; 1 deg is in the unit of
% the value, or one that can be converted to it.
function [factor, hasUnit] = factorOf (word, unit)
  factor = 1;
  hasUnit = ~any (strcmp (word, {'', '%'}));
  if hasUnit && ~strcmp (word, 'abs')
    factor = unitFactor (word, unit);
  end
end

function p = checkPlace (row, where)
  p = checkFault ();
  if isempty (row.name) && isempty (row.series)
    p = checkFault ('measuredName', [where, ', name'], ...
                    'the name of a result, or a series', 'nothing', ...
                    'results.csv of the model has the names.');
  elseif isempty (row.series) ~= isempty (row.at)
    p = checkFault ('measuredAt', where, ...
                    'series and at together, or neither', ...
                    ['series ', describeValue(row.series), ', at ', ...
                     describeValue(row.at)], ...
                    'A point of a curve needs its curve and its place on it.');
  end
  for name = {row.name, row.series}
    if numel (name{1}) > 60 || ...
       ~isempty (regexp (name{1}, '[,;"''\\]', 'once')) || ...
       (~isempty (name{1}) && ~isKind ('text', name{1}))
      p(end + 1) = checkFault ('measuredName', [where, ', name'], ...
                               ['a text of at most 60 characters without ' ...
                                'comma, semicolon or quotes'], ...
                               describeValue (name{1}), 'Rename it.');
    end
  end
end

%!function [r, p] = table (text, models)
%!  file = tempname ();
%!  writeAtomic (file, text);
%!  [r, p] = readMeasured (file, models);
%!endfunction
%!test
%! % decimal commas, CR LF and a byte order mark; an empty value
%! [r, p] = table ([char([239, 187, 191]), "name;value;tol;at;series\r\n", ...
%!                  "slope;31,5;2%;;\r\n;;0,5 abs;2;w\r\noff;0;0,1;;\r\n"], ...
%!                 {'Drum'});
%! assert (isempty (p));
%! assert ([r.value], [31.5, NaN, 0]);
%! assert ([r.tol], [0.02, 0.5, 0.1]);
%! assert ([r.isAbsolute], [false, true, true]);
%! assert ([r.line], [2, 3, 4]);
%! assert ([r.at], [NaN, 2, NaN]);
%! assert ({r.role}, {'', '', ''});
%!test
%! % tolerances with units and signs, remarks, no result, the unit in the header
%! [r, p] = table (["name,value [deg],tol,Comment\na,30,1 deg,x\nb,-,+-2 %,\n", ...
%!                  "c,30,+/-0.5 abs,y\nz,30,5%,\n"], {'Drum'});
%! assert (isempty (p));
%! assert ([r.tol], [1, 0.02, 0.5, 0.05]);
%! assert ([r.isAbsolute], logical ([1, 0, 1, 0]));
%! assert ([r.value], [30, NaN, 30, 30]);
%! assert (unique ({r.unit}), {'deg'});
%! [~, p] = table ("name,value,unit,tol\na,3,kg,1 deg\n", {'Drum'});
%! assert (p.id, 'DEcalioc:checkCase:measuredTol');
%!test
%! % the order may be a time of the day
%! [r, p] = table ("name,value,order\na,3,09:30\na,3,10:00:36\na,3,4\na,3,\n", {'Drum'});
%! assert (isempty (p));
%! assert ([r.order], [9.5, 10.01, 4, NaN], 1e-12);
%! [~, p] = table ("name,value,order\na,3,09:xx\n", {'Drum'});
%! assert (p.id, 'DEcalioc:checkCase:measuredNumber');
%! assert (! isempty (strfind (p.message, 'such as 09:30')));
%!test
%! bad = {'Drum,a,1.2.3,,,,,,', 'Number'; 'Drum,a,1,-1,,,,,', 'Number'; ...
%!        'Drum,a,1,,0,,,,', 'Number'; 'Dram,a,1,,,,,,', 'Model'; ...
%!        ',a,1,,,,,,', 'Model'; 'Drum,,1,,,,,,', 'Name'; ...
%!        'Drum,a,1,,,held,,,', 'Role'; 'Drum,a,1,,,,w,,', 'At'; ...
%!        'Drum,a,1,,,,,,1.5', 'Tol'; 'Drum,a,0,,,,,,2%', 'Tol'};
%! for row = bad'
%!   [~, p] = table (["model,name,value,sd,repeats,role,series,at,tol\n", ...
%!                    row{1}, "\n"], {'Drum', 'Heap'});
%!   assert (p(1).id, ['DEcalioc:checkCase:measured', row{2}]);
%!   assert (! isempty (strfind (p(1).message, 'measured.csv, line 2')));
%! end
%!test
%! for row = {"name,value,weight\na,1,2\n", 'Column'; "name\na\n", 'Column'; ...
%!            "name,value\n", 'Table'; "name,value\na,1,2\n", 'Table'; ...
%!            "Heap,slope,27.5\nHeap,height,0.02\n", 'Column'}'
%!   [list, p] = table (row{1}, {'Drum'});
%!   assert (isempty (list));
%!   assert (p.id, ['DEcalioc:checkCase:measured', row{2}]);
%! end
%!test
%! % what is another measure of the scatter is no misspelt sd
%! for name = {'2sd', 'variance', 'SEM', 's.e.m.', 'CI95', 'std'}
%!   [~, p] = table (["name,value,", name{1}, "\na,1,2\n"], {'Drum'});
%!   assert (! isempty (strfind (p.message, 'the root of a variance')), name{1});
%!   assert (isempty (strfind (p.message, 'Did you mean')));
%! end

% SPDX-License-Identifier: GPL-3.0-only
