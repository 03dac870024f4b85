% READMEASURED  Reads the table of measured values, measured.csv.
%
% CALL: [LIST, FAULTS] = readMeasured (FILE, MODELS)
%
%   FILE      path of the table, in any form that readCsvTable takes
%   MODELS    1 x M cell, names of the models; '' where a name is not usable
%   LIST      1 x n struct, one element a line: line (number in the file),
%             model (number), name, series, unit (texts), at (NaN: none), value
%             (NaN: not measured yet), sd (0: not given), repeats (trials that
%             the value is the mean of; Inf: sd holds their scatter; NaN: not
%             given), role ('': not given), tol (NaN: not given), isAbsolute
%             (logical: tol has the unit of the value), saysTol (logical: there
%             is one, good or bad), condition ('': not given); [] where the
%             table as a whole is no use
%   FAULTS    1 x p faults, see checkFault
%
% Columns, in any order: name or series, and value, are needed; model, where
% there are several; sd, unit, repeats, role, at, tol and condition may be
% missing. tol is a share of the value (0.02 or 2%) or absolute (0.5 abs); of
% the value 0 it is always absolute. Of the conditions one is the reference.
%
% Reasons: measuredTable measuredColumn measuredModel measuredName
% measuredNumber measuredTol measuredRole measuredAt measuredCondition

function [list, p] = readMeasured (file, models)
  list = [];
  try
    [header, cells, lines] = readCsvTable (file);
  catch err
    p = checkFault ('measuredTable', 'measured.csv', ...
                    'a table with a header line', ...
                    err.message, 'Save it as CSV with one header line.');
    return
  end
  known = {'model', 'name', 'value', 'sd', 'unit', 'repeats', 'role', ...
           'series', 'at', 'tol', 'condition'};
  p = checkHeader (header, known, size (cells, 1));
  if ~isempty (p)
    return
  end
  [~, column] = ismember (known, header);
  list = struct ('line', num2cell (lines(:)'));
  for k = 1:numel (list)
    text = repmat ({''}, 1, numel (known));
    text(column > 0) = cells(k, column(column > 0));
    [row, q] = readRow (cell2struct (text(:), known(:)), lines(k), models);
    p = [p, q];
    for name = fieldnames (row)'
      list(k).(name{1}) = row.(name{1});
    end
  end
  p = [p, checkConditions(list, header)];
end

function p = checkHeader (header, known, n)
  p = checkFault ();
  cure = ['The columns are ', strjoin(known, ', '), '.'];
  for k = find (~ismember (header, known))
    p(end + 1) = checkFault ('measuredColumn', 'measured.csv', ...
                             'columns that are known', ...
                             checkShow (header{k}), ...
                             strtrim ([checkNearest(header{k}, known), ...
                                       ' ', cure]));
  end
  [~, once] = unique (header);
  for k = setdiff (1:numel (header), once)
    p(end + 1) = checkFault ('measuredColumn', 'measured.csv', ...
                             'each column once', ...
                             [checkShow(header{k}), ' twice'], cure);
  end
  if ~any (strcmp (header, 'value')) || ...
     ~any (ismember (header, {'name', 'series'}))
    p(end + 1) = checkFault ('measuredColumn', 'measured.csv', ...
                             'the columns name (or series) and value', ...
                             strjoin (header, ', '), cure);
  end
  if n == 0
    p(end + 1) = checkFault ('measuredTable', 'measured.csv', ...
                             'at least one measured value', ...
                             'a header alone', cure);
  end
end

function [row, p] = readRow (text, line, models)
  where = sprintf ('measured.csv, line %d', line);
  [row.model, p] = modelOf (text.model, models, where);
  row.name = text.name;
  row.series = text.series;
  row.unit = text.unit;
  row.condition = text.condition;
  rules = struct ('field', {'value', 'sd', 'repeats', 'at'}, ...
                  'empty', {NaN, 0, NaN, NaN}, ...
                  'isGood', {@isfinite, @(v) v >= 0 & isfinite(v), ...
                             @(v) v > 0, @isfinite}, ...
                  'expected', {'a number, or nothing: not measured yet', ...
                               'a number from 0', ...
                               'a number above 0, or Inf', 'a number'});
  for rule = rules
    [row.(rule.field), q] = numberOf (text.(rule.field), rule, where);
    p = [p, q];
  end
  row.role = text.role;
  if ~any (strcmp (row.role, {'', 'calibrate', 'holdout'}))
    p(end + 1) = checkFault ('measuredRole', [where, ', role'], ...
                             'calibrate or holdout', ...
                             checkShow (row.role), ...
                             'Leave it empty for calibrate.');
  end
  [row.tol, row.isAbsolute, q] = toleranceOf (text.tol, row.value, where);
  row.saysTol = ~isempty (text.tol);
  p = [p, q, checkPlace(text, where)];
end

function [k, p] = modelOf (name, models, where)
  p = checkFault ();
  k = find (strcmp (name, models), 1);
  if isempty (name) && isscalar (models)
    k = 1;
  elseif isempty (k) && ~isempty (models)
    p = checkFault ('measuredModel', [where, ', model'], ...
                    ['one of ', strjoin(models, ', ')], checkShow (name), ...
                    strtrim ([checkNearest(name, models), ...
                              ' Write a model of Input.model.']));
  end
  if isempty (k)
    k = 0;
  end
end

function [value, p] = numberOf (text, rule, where)
  p = checkFault ();
  value = rule.empty;
  if isempty (text)
    return
  end
  value = str2double (text);
  % str2double takes a comma for a separator of thousands
  if any (text == ',') || ~isreal (value) || ~rule.isGood (value)
    value = rule.empty;
    p = checkFault ('measuredNumber', [where, ', ', rule.field], ...
                    rule.expected, checkShow (text), ...
                    ['Decimal commas need semicolons between the ' ...
                     'columns.']);
  end
end

function [tol, isAbsolute, p] = toleranceOf (text, value, where)
  p = checkFault ();
  isAbsolute = value == 0;
  tol = NaN;
  if isempty (text)
    return
  end
  words = regexp (text, '^(\S+?)\s*(%|abs|)$', 'tokens', 'once');
  if ~isempty (words)
    tol = str2double (strrep (words{1}, ',', '.'));
    isAbsolute = isAbsolute || strcmp (words{2}, 'abs');
  end
  isPercent = ~isempty (words) && strcmp (words{2}, '%');
  if isPercent
    tol = tol / 100;
  end
  isGood = tol > 0 && isfinite (tol) && (isAbsolute || tol < 1) && ...
           ~(isPercent && value == 0);
  if ~isGood
    tol = NaN;
    p = checkFault ('measuredTol', [where, ', tol'], ...
                    ['a share of the value between 0 and 1 (0.02 or 2%), ' ...
                     'or 0.5 abs in the unit of the value'], ...
                    checkShow (text), ...
                    'The tolerance of the value 0 is absolute.');
  end
end

function p = checkPlace (text, where)
  p = checkFault ();
  if isempty (text.name) && isempty (text.series)
    p = checkFault ('measuredName', [where, ', name'], ...
                    'the name of a result, or a series', 'nothing', ...
                    'results.csv of the model has the names.');
  elseif isempty (text.series) ~= isempty (text.at)
    p = checkFault ('measuredAt', where, ...
                    'series and at together, or neither', ...
                    ['series ', checkShow(text.series), ', at ', ...
                     checkShow(text.at)], ...
                    ['A point of a curve needs the name of the curve and ' ...
                     'its place on it.']);
  end
  for name = {text.name, text.series}
    if numel (name{1}) > 60 || any (ismember (name{1}, ',;"''\')) || ...
       (~isempty (name{1}) && ~checkIs ('text', name{1}))
      p(end + 1) = checkFault ('measuredName', [where, ', name'], ...
                               ['a text of at most 60 characters without ' ...
                                'comma, semicolon or quotes'], ...
                               checkShow (name{1}), 'Rename it.');
    end
  end
end

%!function [r, p] = table (text, models)
%!  file = tempname ();
%!  writeAtomic (file, text);
%!  [r, p] = readMeasured (file, models);
%!  delete (file);
%!endfunction
%!function check (text, reason)
%!  [~, p] = table (["model,name,value,sd,repeats,role,series,at,tol\n", ...
%!                   text, "\n"], {'Drum', 'Heap'});
%!  assert (p(1).id, ['DEcalioc:checkCase:', reason]);
%!  assert (! isempty (strfind (p(1).message, 'measured.csv, line 2')));
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
%! check ('Drum,a,1.2.3,,,,,,', 'measuredNumber');
%! check ('Drum,a,1,-1,,,,,', 'measuredNumber');
%! check ('Drum,a,1,,0,,,,', 'measuredNumber');
%! check ('Dram,a,1,,,,,,', 'measuredModel');
%! check (',a,1,,,,,,', 'measuredModel');
%! check ('Drum,,1,,,,,,', 'measuredName');
%! check ('Drum,a,1,,,held,,,', 'measuredRole');
%! check ('Drum,a,1,,,,w,,', 'measuredAt');
%! check ('Drum,a,1,,,,,,1.5', 'measuredTol');
%! check ('Drum,a,0,,,,,,2%', 'measuredTol');
%!test
%! [r, p] = table ("name,value,weight\na,1,2\n", {'Drum'});
%! assert (isempty (r));
%! assert (p.id, 'DEcalioc:checkCase:measuredColumn');
%! [~, p] = table ("name\na\n", {'Drum'});
%! assert (p.id, 'DEcalioc:checkCase:measuredColumn');
%! [~, p] = table ("name,value\n", {'Drum'});
%! assert (p.id, 'DEcalioc:checkCase:measuredTable');
%! [~, p] = table ("name,value\na,1,2\n", {'Drum'});
%! assert (p.id, 'DEcalioc:checkCase:measuredTable');
