% OFTOOLBOX  Says which models are test rigs of the toolbox, as rigs have like names.
%
% CALL: TEXT = ofToolbox (MODELS)
%
%   MODELS  1 x M struct array with name and folder
%   TEXT    a sentence behind a blank; '' where all are the user's own

function text = ofToolbox (models)
  rigs = fullfile (fileparts (fileparts (which ('startToolbox'))), 'DEMmodels');
  isRig = strcmp (cellfun (@fileparts, {models.folder}, 'UniformOutput', false), rigs);
  text = '';
  if any (isRig)
    text = sprintf (' (%s: test rig of the toolbox. Call a rig of your own otherwise.)', ...
                    strjoin ({models(isRig).name}, ', '));
  end
end

%!test
%! rigs = fullfile (fileparts (fileparts (which ('startToolbox'))), 'DEMmodels');
%! assert (ofToolbox (struct ('name', {'A', 'Heap'}, 'folder', ...
%!                            {'/x/A', fullfile(rigs, 'Heap')}))(3:6), 'Heap');
%! assert (ofToolbox (struct ('name', 'Heap', 'folder', '/x/Heap')), '');

% SPDX-License-Identifier: GPL-3.0-only
