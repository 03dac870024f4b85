% INFOASRUN  What results are at the settings that a case runs.
%
% CALL: INFO = infoAsRun (INFO, FOLDER, VALUES)
%
%   INFO    1 x m struct array, see resultInfo
%   FOLDER  of the model (text); its sample/places.csv says which variable of
%           data.head is the place of a result: columns name, variable and, where
%           text says it as another number than at, factor (of the variable) and
%           said (that number: 15 turns/min of a speed of 0.5)
%   VALUES  scalar struct of the values that the case gives to variables
%           (modelVars); others are those of the data.head
%   INFO    at of such a result is the value of its variable, and text says it
%           (2 rad/s becomes 1.047 rad/s (10 rpm), 20 mm 25 mm)
%
% See also: targetInfo

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
%! info = struct ('name', {'a', 'b', 'c'}, 'at', {2, 0.02, 2}, 'text', ...
%!                {'slope at 2 rad/s, 12 m', 'slot of 20 mm of 2', 'at 2 rad/s'});
%! assert (isequal (infoAsRun (info, folder, struct ('w', 1)), info));
%! mkdir (fullfile (folder, 'sample'));
%! writeAtomic (fullfile (folder, 'sample', 'places.csv'), ...
%!              "name,variable\na,w\nb,s\nc,none\nq,w\n");
%! now = infoAsRun (info, folder, struct ('w', 1.0471975, 's', 0.025));
%! assert ([now.at], [1.0471975, 0.025, 2]);
%! % of its own data.head, too; a number that the text says in another unit
%! writeAtomic (fullfile (folder, 'data.head'), "variable w equal 3\nvariable s equal 0.02\n");
%! assert (infoAsRun (info, folder, struct ())(1).text, 'slope at 3 rad/s (28.6 rpm), 12 m');
%! writeAtomic (fullfile (folder, 'sample', 'places.csv'), ...
%!              "name,variable,factor,said\nk,v,30,15\nk,t,1,45\na,w,,\n");
%! info(2) = struct ('name', 'k', 'at', NaN, 'text', 'at 45 deg and 15 turns/min');
%! doser = infoAsRun (info, folder, struct ('v', 1 / 3, 't', 40))(2);
%! assert ({doser.text, doser.at}, {'at 40 deg and 10 turns/min', NaN});
%! assert ({now.text}, {'slope at 1.047 rad/s (10 rpm), 12 m', 'slot of 25 mm of 2', 'at 2 rad/s'});

% SPDX-License-Identifier: GPL-3.0-only
