% EXPRESSIBLEEFFECTS  Names of all effects that a case can express.
%
% CALL: NAMES = expressibleEffects (CASE)
%
%   CASE   see newCase
%   NAMES  1 x n cell: of the library and of the user's own, by the models of the
%          case, or by the columns of imported runs

function names = expressibleEffects (Case)
  [names, library] = listEffects ({fullfile(Case.folder, 'effects'), Case.folder});
  effects = cellfun (@(name) getEffect (name, library), names, ...
                     'UniformOutput', false);
  effects = [effects{:}];
  models = Case.models(isfolder ({Case.models.folder}));
  can = effectsOfModel ({models.folder}, effects);
  if isempty (models)
    file = fullfile (Case.folder, 'runs.csv');
    head = {};
    if isfile (file)
      head = readCsvTable (file);
    end
    inTable = arrayfun (@(e) ~e.laboratory && all (ismember (e.variables, head)), ...
                        effects);
    can = inTable | effectsOfModel ('', effects, targetInfo (Case));
  end
  names = {effects(can).name};
end

% SPDX-License-Identifier: GPL-3.0-only
