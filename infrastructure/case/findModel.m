% FINDMODEL  Finds the folder of a DEM model.
%
% CALL: FOLDER = findModel (NAME, CASEFOLDER, ROOT [, VARIABLES])
%
%   NAME        name of the model (text)
%   CASEFOLDER  case folder; its DEMmodels is looked in first (text)
%   ROOT        folder of the toolbox; its DEMmodels comes second (text). Last
%               comes gap/next of the case (filledMeasurements)
%   VARIABLES   cell of texts, the parameters of the case: a model of the toolbox
%               that declares none of them is not meant, as people call a rig of
%               their own Heap
%   FOLDER      path of the model folder, '' where there is none

function folder = findModel (name, caseFolder, root, variables)
  places = cellfun (@(place) fullfile (place, 'DEMmodels', name), ...
                    {caseFolder, root, fullfile(caseFolder, 'gap', 'next')}, ...
                    'UniformOutput', false);
  isThere = isfolder (places);
  if nargin > 3 && isThere(2) && iscell (variables)
    % what is no name is the mistake of another check
    names = variables(cellfun (@(v) isKind ('name', v), variables));
    isThere(2) = isempty (names) || ...
                 any (ismember (names, {checkHead(places{2}).name}));
  end
  found = [places(isThere), {''}];
  folder = found{1};
end

%!assert (findModel ('NoSuchModel', '/nowhere', '/nowhere'), '')
%!test
%! root = fileparts (fileparts (which ('startToolbox')));
%! heap = fullfile (root, 'DEMmodels', 'Heap');
%! assert (findModel ('Heap', '/nowhere', root), heap);
%! assert (findModel ('Heap', '/nowhere', root, {'coefFrictionPP', 'x'}), heap);
%! assert (findModel ('Heap', '/nowhere', root, {'mu', 'rolling'}), '');
%! assert (findModel ('Heap', '/nowhere', root, {['a'; 'b'], 3}), heap);

% SPDX-License-Identifier: GPL-3.0-only
