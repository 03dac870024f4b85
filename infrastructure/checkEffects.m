% CHECKEFFECTS  Checks the candidate effects of loadEffects.
%
% CALL: P = checkEffects (EFFECTS, LIBRARY, MODELVARS, ASSIGN)
%
%   EFFECTS    anything; good are [] and a struct array, see loadEffects
%   LIBRARY    cell of the names of effects that need nothing but their name
%   MODELVARS  [] (not usable) or the scalar struct of loadInput
%   ASSIGN     anything; good is a cell of names
%   P          1 x n problems, see checkProblem
%
% An effect may share a variable with modelVars where its neutral value is the
% same, never with assign or with another effect.
%
% Reasons: badEffects unknownField badEffectName duplicateEffect
% unknownEffect effectVariables badVariableName reservedName neutralShape
% neutralNotFinite effectLimitsShape effectLimits overwrittenVariable
% duplicateEffectVariable
%
% See also: checkCase, loadEffects

function p = checkEffects (effects, library, modelVars, assign)
  p = checkProblem ();
  if checkIs ('nothing', effects)
    return
  end
  if ~isstruct (effects) || ~isfield (effects, 'name')
    p = checkProblem ('badEffects', 'effects', ...
                      '[] or a struct array with at least the field name', ...
                      checkShow (effects), ...
                      'Take loadEffects.m of the toolbox as a pattern.');
    return
  end
  names = {effects.name};
  used = cell (1, 0);
  for k = 1:numel (effects)
    p = [p, checkEffectName(names, k)];
    if isBare (effects(k))
      p = [p, checkLibrary(names{k}, k, library)];
    else
      [q, own] = checkOwn (effects(k), k);
      p = [p, q, checkShared(own, k, used, modelVars, assign)];
      used = [used, own(:, 1)'];
    end
  end
end

function p = checkEffectName (names, k)
  p = checkProblem ();
  field = sprintf ('effects(%d).name', k);
  if ~checkIs ('name', names{k})
    p = checkProblem ('badEffectName', field, ...
                      'a name of letters, digits and _', ...
                      checkShow (names{k}), 'Write a short name.');
  elseif any (strcmp (names{k}, names(1:k - 1)))
    p = checkProblem ('duplicateEffect', field, 'names that differ', ...
                      [names{k}, ' a second time'], ...
                      'Take one of the two out.');
  end
end

function yes = isBare (effect)
  yes = true;
  for name = {'variables', 'neutral', 'limits'}
    yes = yes && (~isfield (effect, name{1}) || ...
                  checkIs ('nothing', effect.(name{1})));
  end
  yes = yes && ~(isfield (effect, 'laboratory') && ...
                 isequal (effect.laboratory, true));
end

function p = checkLibrary (name, k, library)
  p = checkProblem ();
  if checkIs ('name', name) && ~any (strcmp (name, library))
    cure = checkNearest (name, library);
    if isempty (cure)
      cure = 'Give it variables, neutral and limits.';
    end
    p = checkProblem ('unknownEffect', sprintf ('effects(%d).name', k), ...
                      'an effect of the library, or one with variables', ...
                      name, cure);
  end
end

% OWN is n x 2: the usable variables and their neutral values.
function [p, own] = checkOwn (effect, k)
  own = cell (0, 2);
  field = sprintf ('effects(%d).', k);
  isLaboratory = isfield (effect, 'laboratory') && ...
                 isequal (effect.laboratory, true);
  variables = {};
  if isfield (effect, 'variables')
    variables = effect.variables;
  end
  if ischar (variables)
    variables = {variables};
  end
  if ~iscell (variables) || (isempty (variables) && ~isLaboratory) || ...
      ~all (cellfun (@(v) checkIs ('name', v), variables(:)'))
    p = checkProblem ('effectVariables', [field, 'variables'], ...
                      'a cell of names of variables of data.head', ...
                      checkShow (variables), ...
                      'Write for example {''cohesionEnergy''}.');
    return
  end
  v = numel (variables);
  if isLaboratory
    v = max (v, 1);
  end
  p = [checkReserved(variables, field), ...
       checkEffectNumbers(effect, field, v)];
  own = [variables(:), repmat({NaN}, numel (variables), 1)];
  if isempty (p) && ~isempty (variables)
    own(:, 2) = num2cell (double (effect.neutral(:)));
  end
end

function p = checkReserved (variables, field)
  p = checkProblem ();
  reserved = variables(ismember (variables, {'RLTS', 'SIMTS', 'runSeed'}));
  if ~isempty (reserved)
    p = checkProblem ('reservedName', [field, 'variables'], ...
                      'a variable that DEcalioc does not set itself', ...
                      reserved{1}, 'Take it out.');
  end
end

function p = checkShared (own, k, used, modelVars, assign)
  p = checkProblem ();
  field = sprintf ('effects(%d).variables', k);
  if ~iscell (assign)
    assign = {};
  end
  for i = 1:rows (own)
    name = own{i, 1};
    if any (strcmp (name, used)) || any (strcmp (name, own(1:i - 1, 1)))
      p(end + 1) = checkProblem ('duplicateEffectVariable', field, ...
                                 'variables of no other effect', name, ...
                                 'Give each effect a variable of its own.');
    elseif any (cellfun (@(a) isequal (a, name), assign(:)'))
      p(end + 1) = checkProblem ('overwrittenVariable', field, ...
                                 'variables that are not calibrated', ...
                                 [name, ', which assign names too'], ...
                                 'Take it out of assign, or drop the effect.');
    elseif isstruct (modelVars) && isfield (modelVars, name) && ...
        ~isequal (modelVars.(name), own{i, 2})
      p(end + 1) = checkProblem ('overwrittenVariable', field, ...
                                 sprintf ('neutral %s as in modelVars', ...
                                          checkShow (modelVars.(name))), ...
                                 sprintf ('%s with neutral %s', name, ...
                                          checkShow (own{i, 2})), ...
                                 ['Take it out of modelVars, or make the ' ...
                                  'neutral value the same.']);
    end
  end
end

%!shared e
%! e = struct ('name', 'cohesion', 'variables', {{'k'}}, 'neutral', 0, ...
%!             'limits', [0; 1e5]);
%!assert (isempty (checkEffects (e, {}, struct ('k', 0), {'a'})))
%!assert (isempty (checkEffects ([], {}, struct (), {'a'})))
%!assert (isempty (checkEffects (struct ('name', 'tilt'), {'tilt'}, [], {})))
%!assert (checkEffects (struct ('name', 'tlt'), {'tilt'}, [], {}).id, ...
%!        'DEcalioc:checkCase:unknownEffect')
%!assert (checkEffects (e, {}, [], {'k'}).id, ...
%!        'DEcalioc:checkCase:overwrittenVariable')
%!assert (checkEffects (e, {}, struct ('k', 3), {}).id, ...
%!        'DEcalioc:checkCase:overwrittenVariable')
%!test
%! p = checkEffects ([e, e], {}, [], {});
%! assert ({p.id}, strcat ('DEcalioc:checkCase:', ...
%!         {'duplicateEffect', 'duplicateEffectVariable'}));
