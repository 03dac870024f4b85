% RESULTINFO  What the results of a bench are.
%
% CALL: INFO = resultInfo (FOLDER)
%       INFO = resultInfo (FOLDER, VALUES)   at the settings that a case runs
%
% FOLDER  model folder that holds results.csv
% VALUES  scalar struct of values that a case gives to variables, see infoAsRun
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

% SPDX-License-Identifier: GPL-3.0-only
