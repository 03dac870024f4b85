% RESULTINFO  What the results of a bench are.
%
% CALL: INFO = resultInfo (FOLDER)
%       INFO = resultInfo (FOLDER, VALUES)   at the settings that a case runs
%
% FOLDER  model folder that holds results.csv
% VALUES  scalar struct of values that a case gives to variables (modelVars)
% INFO    1 x m struct array in the order of getResults, [] if there is no
%         results.csv: name; kind (density, mass, rate, length, offset, height
%         above the ground, level, angle of a surface that rises along x,
%         angleFalling, coneAngle, curvature, time, stress, friction); unit;
%         series (results of one series belong to one curve, '' for none); at
%         (where on that curve: speed, time, position; NaN for none); text
%
% Throws DEcalioc:resultInfo:badShape, those of readCsvTable.
%
% See also: effectsOfModel, describeEffect
function info = resultInfo (folder, values)
  info = [];
  file = fullfile (folder, 'results.csv');
  if exist (file, 'file') ~= 2
    return
  end
  fields = {'name', 'kind', 'unit', 'series', 'at', 'text'};
  [header, cells] = readCsvTable (file);
  if numel (header) ~= 6
    error ('DEcalioc:resultInfo:badShape', ...
           'resultInfo: %s must have the 6 columns %s, got %d.', file, ...
           strjoin (fields, ', '), numel (header));
  end
  for k = 1:rows (cells)
    info = [info, setfield(cell2struct (cells(k, :), fields, 2), 'at', ...
                           str2double (cells{k, 5}))];
  end
  if nargin > 1
    info = infoAsRun (info, folder, values);
  end
end

% What results are at the settings that a case runs: sample/places.csv of the model says
% which variable of data.head is the place of a result: columns name, variable and, where
% text says it as another number than at, factor (of the variable) and said (that number:
% 15 turns/min of a speed of 0.5). VALUES are of the case, others those of the data.head. at
% of such a result is the value of its variable, and text says it: 2 rad/s becomes 1.047
% rad/s (10 rpm), 20 mm 25 mm.
function info = infoAsRun (info, folder, values)
  file = fullfile (folder, 'sample', 'places.csv');
  if isempty (info) || ~isfile (file)
    return
  end
  own = struct ();                         % a data.head that the user has edited
  if isfile (fullfile (folder, 'data.head'))
    own = headDefaults (fullfile (folder, 'data.head'));
  end
  [header, cells] = readCsvTable (file);
  for row = cell2struct (cells, header, 2)'
    k = find (strcmp ({info.name}, row.name), 1);
    value = givenField (values, row.variable, givenField (own, row.variable, NaN));
    isSame = ~isempty (k) && ~isfield (values, row.variable) && value == info(k).at;
    if ~(isempty (k) || isnan (value) || isSame)
      info(k) = placed (info(k), value, row);
    end
  end
end

function info = placed (info, value, row)
  said = str2double (givenField (row, 'said', ''));
  if isnan (said)
    info.text = withValue (info.text, info.at, value);
    info.at = value;
  else
    info.text = withValue (info.text, said, str2double (row.factor) * value);
  end
end

function text = withValue (text, old, new)
  for factor = [1, 1000]
    word = strrep (sprintf ('%.4g', factor * old), '.', '\.');
    text = regexprep (text, ['(?<![\d.\w])', word, ...
                             '(?![\d.])(?= (?:mm|m|rad/s|Pa|deg|turns/min)\>)'], ...
                      sprintf ('%.4g', factor * new));
  end
  turns = sprintf (' (%.3g rpm)', new * 30 / pi);
  text = regexprep (text, ['(', sprintf('%.4g', new), ' rad/s)'], ['$1', turns]);
end

%!test
%! folder = emptyFolder ();
%! file = fullfile (folder, 'results.csv');
%! fid = fopen (file, 'w');
%! fputs (fid, ["name,kind,unit,series,at,text\nw,rate,kg/s,w,2,rate\n", ...
%!              "m,mass,kg,,,all\n"]);
%! fclose (fid);
%! info = resultInfo (folder);
%! assert ({info.name}, {'w', 'm'});
%! assert ([info.at], [2, NaN]);
%! assert (info(2).series, '');

%!assert (isempty (resultInfo ('no such folder')))
%!test
%! % at the settings that a case runs
%! folder = emptyFolder ();
%! writeAtomic (fullfile (folder, 'results.csv'), ...
%!              ["name,kind,unit,series,at,text\na,,,,2,\"slope at 2 rad/s, 12 m\"\n", ...
%!               "b,,,,0.02,slot of 20 mm of 2\nc,,,,2,at 2 rad/s\n"]);
%! info = resultInfo (folder);
%! assert (isequal (resultInfo (folder, struct ('w', 1)), info));
%! mkdir (fullfile (folder, 'sample'));
%! writeAtomic (fullfile (folder, 'sample', 'places.csv'), ...
%!              "name,variable\na,w\nb,s\nc,none\nq,w\n");
%! now = resultInfo (folder, struct ('w', 1.0471975, 's', 0.025));
%! assert ([now.at], [1.0471975, 0.025, 2]);
%! assert ({now.text}, {'slope at 1.047 rad/s (10 rpm), 12 m', 'slot of 25 mm of 2', 'at 2 rad/s'});
%! % of its own data.head, too; a number that the text says in another unit
%! writeAtomic (fullfile (folder, 'data.head'), "variable w equal 3\nvariable s equal 0.02\n");
%! assert (resultInfo (folder, struct ())(1).text, 'slope at 3 rad/s (28.6 rpm), 12 m');
%! writeAtomic (fullfile (folder, 'results.csv'), ...
%!              "name,kind,unit,series,at,text\nk,,,,,at 45 deg and 15 turns/min\n");
%! writeAtomic (fullfile (folder, 'sample', 'places.csv'), ...
%!              "name,variable,factor,said\nk,v,30,15\nk,t,1,45\na,w,,\n");
%! doser = resultInfo (folder, struct ('v', 1 / 3, 't', 40));
%! assert ({doser.text, doser.at}, {'at 40 deg and 10 turns/min', NaN});

% SPDX-License-Identifier: GPL-3.0-only
