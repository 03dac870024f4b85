% READSETTINGS  What an experimenter can change on a bench.
%
% CALL: SETTINGS = readSettings (FOLDER)
%
%   FOLDER    model folder (text)
%   SETTINGS  1 x s struct: variable (of data.head), unit (SI, '': none), values
%             (1 x v, other ones than that of data.head), text (what the bench
%             has then, %s the value with its unit: 'a right slot of %s');
%             empty where FOLDER has no settings.csv
%
% settings.csv has these four columns, blanks between values. It decides no run.
%
% Errors: DEcalioc:readSettings:badShape, those of readCsvTable

function settings = readSettings (folder)
  settings = struct ('variable', {}, 'unit', {}, 'values', {}, 'text', {});
  file = fullfile (folder, 'settings.csv');
  if isempty (folder) || ~isfile (file)
    return
  end
  [header, cells] = readCsvTable (file);
  [isThere, column] = ismember (fieldnames (settings)', header);
  for k = 1:size (cells, 1) * all (isThere)
    row = cells(k, column);
    values = str2double (strsplit (strtrim (row{3})));
    isGood = all (isfinite (values)) && isvarname (row{1}) && ...
             numel (strfind (row{4}, '%s')) == 1 && ...
             numel (strfind (row{4}, '%')) == 1;
    if ~isGood
      isThere = false;
      break
    end
    settings(k) = struct ('variable', row{1}, 'unit', row{2}, 'values', ...
                          values, 'text', row{4});
  end
  if ~all (isThere)
    error ('DEcalioc:readSettings:badShape', ...
           ['readSettings: %s must have the columns variable, unit, values ' ...
            '(numbers with blanks between) and text (with %%s where the ' ...
            'value belongs), got another line.'], file);
  end
end

%!function folder = with (text)
%!  folder = emptyFolder ();
%!  writeAtomic (fullfile (folder, 'settings.csv'), text);
%!endfunction
%!test
%! folder = with (["variable,unit,values,text\n", ...
%!                 "slot,m,0.03 0.045,a slot of %s\n"]);
%! s = readSettings (folder);
%! assert ({s.variable, s.unit, s.text}, {'slot', 'm', 'a slot of %s'});
%! assert (s.values, [0.03, 0.045]);
%! assert (isempty (readSettings (tempdir ())));
%!error id=DEcalioc:readSettings:badShape
%! readSettings (with ("variable,unit,values,text\nslot,m,wide,slot of %s\n"));
%!error id=DEcalioc:readSettings:badShape
%! readSettings (with ("variable,unit,values\nslot,m,1\n"));
%!test
%! % those of the toolbox: variables that data.head declares, at other values
%! root = fileparts (fileparts (which ('startToolbox')));
%! for file = glob (fullfile (root, 'DEMmodels', '*', 'settings.csv'))'
%!   folder = fileparts (file{1});
%!   defaults = headDefaults (fullfile (folder, 'data.head'));
%!   for s = readSettings (folder)
%!     assert (isfield (defaults, s.variable), [folder, ': ', s.variable]);
%!     assert (~any (s.values == defaults.(s.variable)));
%!   end
%! end

% SPDX-License-Identifier: GPL-3.0-only
