% WEIGHEDRESULTS  Says that the results of standInCase are masses.
%
% CALL: weighedResults (FOLDER)
%
%   FOLDER  of a case of standInCase: what a balance shows wrong acts on them

function weighedResults (folder)
  for model = {'First', 'Second'; {'First_1', 'First_2'}, {'Second_1'}}
    lines = sprintf ("%s,mass,kg,,,\n", model{2}{:});
    writeAtomic (fullfile (folder, 'DEMmodels', model{1}, 'results.csv'), ...
                 ["name,kind,unit,series,at,text\n", lines]);
  end
end

% SPDX-License-Identifier: GPL-3.0-only
