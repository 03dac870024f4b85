% NEEDCANDIDATES  Stops where no candidate effect is listed.
%
% CALL: needCandidates (CASE)
%
%   CASE  see newCase, with its effects (withEffects)
%
% Without candidates there is nothing to choose from: said before any run, with
% a list of what the models of the case can express, to be copied.
%
% Errors: DEcalioc:needCandidates:missingField

function needCandidates (Case)
  if ~isempty (Case.effects)
    return
  end
  folders = fullfile (Case.folder, 'effects');
  effects = cellfun (@(name) getEffect (name, folders), ...
                     listEffects (folders), 'UniformOutput', false);
  effects = [effects{:}];
  models = Case.models(isfolder ({Case.models.folder}));
  can = repmat (isempty (models), 1, numel (effects));
  for model = models
    can = can | effectsOfModel (model.folder, effects);
  end
  error ('DEcalioc:needCandidates:missingField', ...
         ['loadEffects.m must list what the model may lack, got an empty ' ...
          'list. Your models can express these; copy the line to ' ...
          'loadEffects.m and strike out what cannot be (docs/effects.md):' ...
          '\n  effects = {''%s''};'], strjoin ({effects(can).name}, ''', '''));
end

%!test
%! Case.effects = [];
%! Case.folder = tempname ();
%! root = fileparts (which ('DEcalioc'));
%! Case.models = struct ('folder', fullfile (root, 'DEMmodels', 'Heap'));
%! try
%!   needCandidates (Case);
%!   said = '';
%! catch err
%!   said = err.message;
%! end
%! assert (! isempty (strfind (said, '''cohesion''')));
%! assert (isempty (strfind (said, 'speedError')));
%! Case.effects = struct ('name', 'tilt');
%! needCandidates (Case);
%!error id=DEcalioc:needCandidates:missingField
%! needCandidates (struct ('effects', [], 'folder', '', ...
%!                         'models', struct ('folder', '')));
