% CHECKEFFECTS  Checks the candidate effects of loadEffects.
%
% CALL: [P, EFFECTS] = checkEffects (LIST, FOLDERS, MODELVARS, ASSIGN)
%
%   LIST       anything; good is what loadEffects may give, see resolveEffects
%   FOLDERS    cell of folders that are looked in before the effect library
%   MODELVARS  [] (not usable) or the scalar struct of loadInput
%   ASSIGN     anything; good is a cell of names
%   P          1 x n faults, see checkFault
%   EFFECTS    1 x e struct array of the usable ones: field (how the user
%              writes it), variables (1 x v cell), neutral (1 x v)
%
% An effect may share a variable with modelVars where its neutral value is the
% same, never with assign or with another effect.
%
% Reasons: badEffects unknownField badEffectName reservedName duplicateEffect
% unknownEffect brokenEffect overwrittenVariable duplicateEffectVariable, and
% those of checkEffectNumbers

function [p, effects] = checkEffects (list, folders, modelVars, assign)
  effects = struct ('field', cell (1, 0), 'variables', [], 'neutral', []);
  [p, entries] = asEntries (list);
  if ~isempty (p) || isempty (entries)
    return
  end
  library = listEffects (folders);
  names = {};
  for k = 1:numel (entries)
    field = sprintf ('effects(%d)', k);
    [q, entry] = checkEntry (entries{k}, field, names);
    p = [p, q];
    if isstruct (entry)
      names{end + 1} = entry.name;
      [q, entry] = complete (entry, field, library, folders);
      p = [p, q];
      if isempty (q)
        p = [p, checkEffectNumbers(entry, [field, '.'])];
        effects(end + 1) = usable (entry, field);
      end
    end
  end
  p = [p, checkShared(effects, modelVars, assign)];
end

function [p, entries] = asEntries (list)
  p = checkFault ();
  entries = {};
  if checkIs ('nothing', list)
    return
  elseif checkIs ('text', list)
    entries = {list};
  elseif isstruct (list)
    entries = num2cell (list(:)');
  elseif iscell (list)
    entries = list(:)';
  else
    p = checkFault ('badEffects', 'effects', ...
                    '[], or a struct array with at least the field name', ...
                    checkShow (list), ...
                    'Take loadEffects.m of the toolbox as a pattern.');
  end
end

% ENTRY comes back as a struct with a good name and without empty fields, or
% as [].
function [p, entry] = checkEntry (entry, field, names)
  if ischar (entry)
    entry = struct ('name', entry);
  end
  if ~checkIs ('struct', entry) || ~isfield (entry, 'name')
    p = checkFault ('badEffects', field, ...
                    'a name, or a struct with at least the field name', ...
                    checkShow (entry), ...
                    'Take loadEffects.m of the toolbox as a pattern.');
    entry = [];
    return
  end
  known = {'name', 'variables', 'neutral', 'limits', 'label', 'unit', ...
           'group', 'laboratory', 'question', 'priorScale', 'benches', ...
           'confusedWith', 'kinds', 'transform', 'source'};
  p = [checkFields(entry, field, known), ...
       checkEffectName(entry.name, [field, '.name'], names)];
  if ~checkIs ('name', entry.name)
    entry = [];
    return
  end
  fields = fieldnames (entry);
  isGiven = ~cellfun (@(f) checkIs ('nothing', entry.(f)), fields);
  entry = rmfield (entry, fields(~isGiven));
end

function p = checkEffectName (name, field, names)
  p = checkFault ();
  if ~checkIs ('name', name)
    p = checkFault ('badEffectName', field, ...
                    'a name of letters, digits and _', ...
                    checkShow (name), 'Write a short name.');
  elseif any (strcmp (name, {'null', 'unlisted'}))
    p = checkFault ('reservedName', field, ...
                    'a name that is none of gap.json''s own', name, ...
                    'Call it something else.');
  elseif any (strcmp (name, names))
    p = checkFault ('duplicateEffect', field, 'names that differ', ...
                    [name, ' a second time'], ...
                    'Take one of the two out.');
  end
end

% What a name of the library stands for is filled in.
function [p, entry] = complete (entry, field, library, folders)
  p = checkFault ();
  given = isfield (entry, {'variables', 'neutral', 'limits'});
  if any (strcmp (entry.name, library))
    try
      base = getEffect (entry.name, folders);
    catch err
      p = checkFault ('brokenEffect', [field, '.name'], ...
                      sprintf ('a library file of %s that runs', ...
                               entry.name), checkShow (err.message), ...
                      'Call getEffect at the Octave prompt until it runs.');
      return
    end
    entry = mergeFields (base, entry);
  elseif ~any (given)
    cure = checkNearest (entry.name, library);
    if isempty (cure)
      cure = 'Give it variables, neutral and limits.';
    end
    p = checkFault ('unknownEffect', [field, '.name'], ...
                    'an effect of the library, or one with variables', ...
                    entry.name, cure);
  end
end

function effect = usable (entry, field)
  effect = struct ('field', [field, '.variables'], ...
                   'variables', {cell(1, 0)}, 'neutral', zeros (1, 0));
  if isfield (entry, 'variables') && iscell (entry.variables)
    effect.variables = entry.variables(:)';
    effect.neutral = NaN (1, numel (entry.variables));
    if isfield (entry, 'neutral') && ...
        isequal (size (entry.neutral), size (effect.neutral))
      effect.neutral = entry.neutral;
    end
  end
end

function p = checkShared (effects, modelVars, assign)
  p = checkFault ();
  designs = {};
  if iscell (assign)
    designs = assign(cellfun (@(a) checkIs ('text', a), assign));
  end
  names = [cell(1, 0), effects.variables];
  fields = arrayfun (@(e) repmat ({e.field}, 1, numel (e.variables)), ...
                     effects, 'UniformOutput', false);
  fields = [cell(1, 0), fields{:}];
  neutral = num2cell ([effects.neutral]);
  for i = find (cellfun (@(n) checkIs ('name', n), names))
    name = names{i};
    if any (strcmp (name, names(1:i - 1)))
      p(end + 1) = checkFault ('duplicateEffectVariable', fields{i}, ...
                               'variables of no other effect', name, ...
                               'Give each effect a variable of its own.');
    elseif any (strcmp (name, designs))
      p(end + 1) = checkFault ('overwrittenVariable', fields{i}, ...
                               'variables that are not calibrated', ...
                               [name, ', which assign names too'], ...
                               'Take it out of assign or out of effects.');
    elseif isstruct (modelVars) && isfield (modelVars, name) && ...
        ~isequal (modelVars.(name), neutral{i})
      p(end + 1) = checkFault ('overwrittenVariable', fields{i}, ...
                               ['neutral values as in modelVars: ', ...
                                checkShow(modelVars.(name))], ...
                               [name, ' with ', checkShow(neutral{i})], ...
                               'Take it out of modelVars.');
    end
  end
end

%!shared e
%! e = struct ('name', 'lid', 'variables', {{'k'}}, 'neutral', 0, ...
%!             'limits', [0; 1e5]);
%!assert (isempty (checkEffects (e, {}, struct ('k', 0), {'a'})))
%!assert (isempty (checkEffects ([], {}, struct (), {'a'})))
%!assert (isempty (checkEffects ({'tilt', e}, {}, [], {})))
%!test
%! [p, effects] = checkEffects (struct ('name', 'tilt', 'limits', [0; 1]), ...
%!                              {}, [], {});
%! assert (isempty (p));
%! assert (effects.variables, {'tiltAngle'});
%!assert (checkEffects (setfield (e, 'name', 'unlisted'), {}, [], {}).id, ...
%!        'DEcalioc:checkCase:reservedName')
%!assert (checkEffects ('tlt', {}, [], {}).id, ...
%!        'DEcalioc:checkCase:unknownEffect')
%!assert (checkEffects (e, {}, [], {'k'}).id, ...
%!        'DEcalioc:checkCase:overwrittenVariable')
%!assert (checkEffects (e, {}, struct ('k', 3), {}).id, ...
%!        'DEcalioc:checkCase:overwrittenVariable')
%!test
%! p = checkEffects ([e, e], {}, [], {});
%! assert ({p.id}, strcat ('DEcalioc:checkCase:', ...
%!         {'duplicateEffect', 'duplicateEffectVariable'}));
