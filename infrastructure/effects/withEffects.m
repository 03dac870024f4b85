% WITHEFFECTS  Adds the user's candidate effects to a case.
%
% CALL: CASE = withEffects (CASE)
%       CASE = withEffects (CASE, LIST)
%
%   CASE  see newCase; comes back with effects, their variables in effectVars, and
%         unchanged (cell: names of those that, of a change, the user says cannot
%         have changed; they are no effects then) and origin (withOrigin: what is known
%         to have happened, in words; '': nothing)
%   LIST  the candidates, as loadEffects gives them (default: those of
%         loadEffects.m of the case or of the toolbox); may be empty
%
% Errors: DEcalioc:withEffects:brokenEffects, those of withOrigin, resolveEffects
% and checkDeclared (DEcalioc:checkCase:...). An effect of the library may be
% one that no model of the case has; of the user's own ones that is a mistake.

function Case = withEffects (Case, list)
  if nargin < 2
    list = ownList ();
  end
  folders = {fullfile(Case.folder, 'effects'), Case.folder};
  [Case.effects, faults] = resolveEffects (list, folders, Case.modelVars, ...
                                           Case.names);
  stopAt (faults);
  Case.unchanged = {};
  if ~isempty (givenField (Case, 'conditions', {})) && ~isempty (Case.effects)
    isOut = strcmp (changeWords (Case.effects), 'no');
    Case.unchanged = {Case.effects(isOut).name};
    Case.effects = Case.effects(~isOut);
  end
  Case.effectVars = plainCase (Case).effectVars;
  for effect = Case.effects
    Case.effectVars = [Case.effectVars, effect.variables(:)'];
  end
  stopAt (checkModelsHave (Case));
  stopAt (checkTransforms (Case));
  [Case, Case.origin] = withOrigin (Case);
end

function list = ownList ()
  list = [];
  % which would parse it, outside of try
  file = file_in_loadpath ('loadEffects.m');
  if isempty (file)
    return
  end
  clear ('-functions', 'loadEffects');    % as in readInput
  try
    list = feval ('loadEffects');
  catch err
    error ('DEcalioc:withEffects:brokenEffects', ...
           ['withEffects: %s must return a struct array of effects, but ' ...
            'running it gave: %s'], file, strtrim (err.message));
  end
end

function stopAt (faults)
  if ~isempty (faults)
    error (faults(1).id, 'withEffects: %s', ...
           strjoin ({faults.message}, "\n"));
  end
end

function p = checkModelsHave (Case)
  p = checkFault ();
  models = Case.models(isfolder ({Case.models.folder}));
  heads = cellfun (@checkHead, {models.folder}, 'UniformOutput', false);
  [models.head] = heads{:};
  library = listEffects ();
  for effect = Case.effects
    names = effect.variables;
    fields = repmat ({['effects, ', effect.name, ',']}, 1, numel (names));
    kinds = repmat ({'effect'}, 1, numel (names));
    found = checkDeclared (names, fields, kinds, models);
    if ~isempty (found) && any (strcmp (effect.name, library))
      found = found(~strcmp ({found.id}, 'DEcalioc:checkCase:unknownVariable'));
    end
    p = [p, found, checkNeutral(effect, models, Case.modelVars)];
  end
end

% Calibrated is with what data.head says, compared with what is neutral.
function p = checkNeutral (effect, models, modelVars)
  p = checkFault ();
  for k = 1:numel (models)
    for j = 1:numel (effect.variables)
      name = effect.variables{j};
      own = str2double ({models(k).head(strcmp ({models(k).head.name}, name)).value});
      if isempty (own) || isfield (modelVars, name) || isnan (own(end)) || ...
         abs (own(end) - effect.neutral(j)) <= 1e-9 * abs (own(end))
        continue
      end
      p = checkFault ('overwrittenVariable', ['effects, ', effect.name, ', neutral'], ...
                      sprintf ('%s as data.head of %s has it: %.15g', name, ...
                               models(k).name, own(end)), ...
                      sprintf ('%.15g', effect.neutral(j)), ...
                      ['At neutral the model is the one that is calibrated: make both ' ...
                       'alike.']);
    end
  end
end

% Those of the library have tests of their own.
function p = checkTransforms (Case)
  p = checkFault ();
  if isempty (Case.effects) || isempty (givenField (Case, 'targets', []))
    return
  end
  info = targetInfo (Case);
  isOwn = ~ismember ({Case.effects.name}, listEffects ()) & [Case.effects.laboratory];
  for effect = Case.effects(isOwn & ~isempty (info))
    p = [p, transformFaults(effect, info)];
  end
end

%!function Case = withOwn (effect)
%!  Case = readyCase ();
%!  writeAtomic (fullfile (Case.folder, 'loadEffects.m'), ...
%!               ["function e = loadEffects ()\ne = ", effect, ";\nend\n"]);
%!  here = cd (Case.folder);
%!  clear loadEffects
%!  tidy = onCleanup (@() cd (here));
%!  Case = withEffects (Case);
%!endfunction
%!test
%! own = ["struct('name', 'own', 'variables', {{'e'}}, 'neutral', 0, ", ...
%!        "'limits', [0; 1])"];
%! assert (withOwn (['{''tilt'', ', own, '}']).effectVars, {'tiltAngle', 'e'});
%!assert (numel (withOwn ("{'gain', 'tilt'}").effects), 2)
%!test
%! % what cannot have changed is no candidate of a change, but one of a gap
%! Case = readyCase ();
%! list = {'gain', struct('name', 'tilt', 'canChange', 'no')};
%! assert (numel (withEffects (Case, list).effects), 2);
%! Case.conditions = {'moist'};
%! Case = withEffects (Case, list);
%! assert ({Case.effects.name, Case.unchanged{:}}, {'gain', 'tilt'});
%!error <expected e as data.head of Second has it: 0, got 0.5>
%! withOwn (["struct('name', 'own', 'variables', {{'e'}}, 'neutral', 0.5, ", ...
%!           "'limits', [0.6; 1])"]);
%!error id=DEcalioc:checkCase:effectTransform
%! withOwn (["struct('name', 'own', 'laboratory', true, 'neutral', 0, 'limits', ", ...
%!           "[0; 1], 'kinds', {{'mass'}}, 'transform', @(Z, s) Z)"]);
%!error id=DEcalioc:withEffects:brokenEffects withOwn ('nope')
%!error id=DEcalioc:withEffects:brokenEffects withOwn ("{'gain', ")
%!error id=DEcalioc:checkCase:unknownVariable
%! withOwn (["struct ('name', 'own', 'variables', {{'ee'}}, 'neutral', 0, ", ...
%!           "'limits', [0; 1])"]);

% SPDX-License-Identifier: GPL-3.0-only
