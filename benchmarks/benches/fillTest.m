% FILLTEST  Fills in the table of an advised test, as a user who measures does.
%
% CALL: fillTest (PLACE, MODEL, VALUES)
%
%   PLACE   text, folder gap/next of the case, where MODEL.csv lies
%   MODEL   text, name of the advised bench
%   VALUES  scalar struct of what the material is
%
% Each trial is a run with a packing of its own (truthRuns) and a reading error
% (randn): of the sd that the table holds, or of the scatter of the bench's
% results (scatter.csv), which is filled in then.
%
% See also: writeNextMeasurement, wholeRuns

function fillTest (place, model, values)
  folder = fullfile (place, 'DEMmodels', model);
  if ~isfolder (folder)
    root = fileparts (fileparts (which ('startToolbox')));
    folder = fullfile (root, 'DEMmodels', model);
  end
  names = {resultInfo(folder).name};
  scatter = scatterOf (folder, names);
  file = fullfile (place, [model, '.csv']);
  lines = strsplit (strtrim (fileread (file)), "\n");
  Y = truthRuns (folder, values, 3, fullfile (fileparts (place), ...
                                              ['truth-', model]));
  trial = zeros (size (names));
  for i = 5:numel (lines)
    fields = ostrsplit (lines{i}, ',');
    at = find (strcmp (names, [fields{2}, repmat(fields{3}, 1, ...
                                                 isempty (fields{2}))]), 1);
    trial(at) = trial(at) + 1;
    sd = str2double (fields{6});
    if isnan (sd)
      sd = scatter(at);
    end
    fields{5} = sprintf ('%.8g', Y(trial(at), at) + sd * randn ());
    fields{6} = sprintf ('%.4g', sd);
    lines{i} = strjoin (fields, ',');
  end
  writeAtomic (file, [strjoin(lines, "\n"), "\n"]);
end

function sd = scatterOf (folder, names)
  sd = NaN (size (names));
  file = fullfile (folder, 'scatter.csv');
  if isfile (file)
    sd = runScatter (folder);
  end
end

% SPDX-License-Identifier: GPL-3.0-only
