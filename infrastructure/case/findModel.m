% FINDMODEL  Finds the folder of a DEM model.
%
% CALL: FOLDER = findModel (NAME, CASEFOLDER, ROOT)
%
%   NAME        name of the model (text)
%   CASEFOLDER  case folder; its DEMmodels is looked in first (text)
%   ROOT        folder of the toolbox; its DEMmodels comes second (text)
%   FOLDER      path of the model folder, '' where there is none

function folder = findModel (name, caseFolder, root)
  folder = '';
  places = {caseFolder, root};
  for k = 1:numel (places)
    candidate = fullfile (places{k}, 'DEMmodels', name);
    if isfolder (candidate)
      folder = candidate;
      return
    end
  end
end

%!assert (findModel ('NoSuchModel', '/nowhere', '/nowhere'), '')
