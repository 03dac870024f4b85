% INFOASRUN  What results are at the settings that a case runs.
%
% CALL: INFO = infoAsRun (INFO, FOLDER, VALUES)
%
%   INFO    1 x m struct array, see resultInfo
%   FOLDER  of the model (text); its sample/places.csv says which variable of
%           data.head is the place of a result: columns name, variable
%   VALUES  scalar struct of the values that the case gives to variables
%           (modelVars); others stay
%   INFO    at of such a result is the value of its variable, and text says it
%           (2 rad/s becomes 1.047 rad/s (10 rpm), 20 mm 25 mm)
%
% See also: targetInfo

function info = infoAsRun (info, folder, values)
  file = fullfile (folder, 'sample', 'places.csv');
  if isempty (info) || isempty (fieldnames (values)) || ~isfile (file)
    return
  end
  [header, cells] = readCsvTable (file);
  [~, column] = ismember ({'name', 'variable'}, header);
  for row = cells(:, column)'
    k = find (strcmp ({info.name}, row{1}), 1);
    if ~isempty (k) && isfield (values, row{2})
      value = values.(row{2});
      info(k).text = withValue (info(k).text, info(k).at, value);
      info(k).at = value;
    end
  end
end

function text = withValue (text, old, new)
  for factor = [1, 1000]
    word = strrep (sprintf ('%.4g', factor * old), '.', '\.');
    text = regexprep (text, ['(?<![\d.\w])', word, '(?![\d.])(?= (?:mm|m|rad/s|Pa)\>)'], ...
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
%! assert ({now.text}, {'slope at 1.047 rad/s (10 rpm), 12 m', 'slot of 25 mm of 2', 'at 2 rad/s'});

% SPDX-License-Identifier: GPL-3.0-only
