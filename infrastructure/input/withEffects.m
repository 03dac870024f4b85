% WITHEFFECTS  Adds the user's candidate effects to a case.
%
% CALL: CASE = withEffects (CASE)
%
%   CASE  see newCase
%
% The candidates are those of loadEffects.m, of the case or of the toolbox; an
% empty list is allowed.
%
% Errors: DEcalioc:withEffects:brokenEffects, those of checkEffects
%
% See also: loadEffects, resolveEffects

function Case = withEffects (Case)
  if isempty (which ('loadEffects'))
    return
  end
  try
    list = loadEffects ();
  catch err
    error ('DEcalioc:withEffects:brokenEffects', ...
           ['withEffects: %s must return a struct array of effects, but ' ...
            'running it gave: %s'], which ('loadEffects'), err.message);
  end
  folders = {fullfile(Case.folder, 'effects'), Case.folder};
  problems = checkEffects (list, folders, Case.modelVars, Case.names);
  if ~isempty (problems)
    error (problems(1).id, 'withEffects: %s', ...
           strjoin ({problems.message}, "\n"));
  end
  Case.effects = resolveEffects (list, folders);
  Case.effectVars = variablesOfEffects (Case.effects);
end
