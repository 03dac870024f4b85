% CHECKMEASUREDRESULTS  Compares what was measured with the results of a model.
%
% CALL: P = checkMeasuredResults (GROUPS, MODELS, LINES)
%
%   GROUPS  of groupMeasured
%   MODELS  1 x M struct array, see checkFindModels
%   LINES   those of the tables, of readConditions
%   P       1 x n faults, see checkFault
%
% What is known of the results: results.csv, and the fields that getResults
% returned without a run. A series of results.csv is measured as a series only.
% Units are texts: those of both tables must be the same, where both have one.

function p = checkMeasuredResults (groups, models, lines)
  p = checkUnits (lines, models);
  for g = groups
    m = models(g.model);
    info = infoOf (m.folder);
    names = {info.name};
    series = unique ({info.series});
    series = series(~cellfun (@isempty, series));
    known = [names, m.fields, series(1:end * ~isempty (g.series))];
    if isempty (m.folder) || (isempty (known) && isnan (m.count)) || ...
       any (ismember ({g.result, g.series}, known))
      continue
    end
    choice = strjoin (unique (known), ', ');
    if isempty (known)
      choice = 'none of them has a name';
    end
    p(end + 1) = checkFault ('measuredResult', ...
                             sprintf ('%s, line %d', g.file, g.line), ...
                             ['a result of ', m.name, ': ', choice], ...
                             checkShow (g.result), ...
                             strtrim ([checkNearest(g.result, known), ...
                                       ' Name it in results.csv of the ' ...
                                       'model, or let getResults return ' ...
                                       'a struct with this field.']));
  end
end

% A unit that is wrong all along a curve is one fault.
function p = checkUnits (lines, models)
  p = checkFault ();
  lines = lines(~cellfun (@isempty, {lines.unit}));
  keys = arrayfun (@(o) strjoin ({o.file, models(o.model).name, o.name, ...
                                  o.series, o.unit}, "\n"), lines, ...
                   'UniformOutput', false);
  [~, first] = unique (keys, 'first');
  for one = lines(sort (first))
    info = infoOf (models(one.model).folder);
    isIt = strcmp ({info.name}, one.name) | ...
           (~isempty (one.series) & (strcmp ({info.name}, one.series) | ...
                                     strcmp ({info.series}, one.series)));
    units = setdiff ({info(isIt).unit}, {''});
    if ~isempty (units) && ~any (strcmp (units, one.unit))
      p(end + 1) = checkFault ('measuredUnit', ...
                               sprintf ('%s, line %d, unit', one.file, ...
                                        one.line), ...
                               [checkShow(units{1}), ', as results.csv of ', ...
                                models(one.model).name, ' has it'], ...
                               checkShow (one.unit), ...
                               ['Convert the value and its sd, or correct ' ...
                                'the unit in one of the two.']);
    end
  end
end

% Without a table, or one that cannot be read, 1 x 0.
function info = infoOf (folder)
  info = struct ('name', cell (1, 0), 'unit', '', 'series', '');
  if isempty (folder)
    return
  end
  try
    found = resultInfo (folder);
  catch
    return
  end
  if ~isempty (found)
    info = found;
  end
end

%!function reasons = check (text, model)
%!  file = tempname ();
%!  writeAtomic (file, text);
%!  lines = readMeasured (file, {'Toy'});
%!  p = checkMeasuredResults (groupMeasured (lines, {'Toy'}), model, lines);
%!  reasons = arrayfun (@(q) q.id(20:end), p, 'UniformOutput', false);
%!endfunction
%!shared model
%! folder = tempname ();
%! mkdir (folder);
%! model = struct ('name', 'Toy', 'folder', folder, 'count', 1, 'fields', {{}});
%!test
%! % what results.csv names as a series is no result of its own
%! writeAtomic (fullfile (model.folder, 'results.csv'), ...
%!              "name,kind,unit,series,at,text\ntop,height,m,w,1,t\n");
%! assert (isempty (check ("name,value\ntop,1\n", model)));
%! assert (isempty (check ("name,series,at,value\n,w,1,3\n,w,2,4\n", model)));
%! assert (check ("name,value\nw,1\n", model), {'measuredResult'});
%!test
%! % units, of a result and of a curve, which is one fault
%! writeAtomic (fullfile (model.folder, 'results.csv'), ...
%!              ["name,kind,unit,series,at,text\ntop,mass,kg,,,t\n", ...
%!               "w,mass,%,,,t\nfree,,,,,t\n"]);
%! head = "name,value,unit,series,at\n";
%! assert (isempty (check ([head, "top,1,kg,,\ntop,2,,,\nfree,1,g,,\n", ...
%!                          ",1,%,w,1\n"], model)));
%! assert (check ([head, "top,13.5,g,,\n"], model), {'measuredUnit'});
%! assert (check ([head, ",1,g,w,1\n,2,g,w,2\n"], model), {'measuredUnit'});
