% FINDMODEL  Finds the folder of a DEM model.
%
% CALL: FOLDER = findModel (NAME, CASEFOLDER, ROOT)
%
%   NAME        name of the model (text)
%   CASEFOLDER  case folder; its DEMmodels is looked in first (text)
%   ROOT        folder of the toolbox; its DEMmodels comes second (text). Last
%               comes gap/next of the case (filledMeasurements)
%   FOLDER      path of the model folder, '' where there is none

function folder = findModel (name, caseFolder, root)
  places = cellfun (@(place) fullfile (place, 'DEMmodels', name), ...
                    {caseFolder, root, fullfile(caseFolder, 'gap', 'next')}, ...
                    'UniformOutput', false);
  found = [places(isfolder (places)), {''}];
  folder = found{1};
end

%!assert (findModel ('NoSuchModel', '/nowhere', '/nowhere'), '')
