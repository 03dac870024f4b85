% RESOLVEEFFECTS  Checks and completes the user's list of candidate effects.
%
% CALL: EFFECTS = resolveEffects (LIST)
%       [EFFECTS, P] = resolveEffects (LIST, FOLDERS, MODELVARS, ASSIGN)
%
%   LIST       what loadEffects gives: [] or {}; a name; a cell of names and
%              structs; a struct array. A struct needs a name; what it does not
%              give (or gives empty) comes from the library's file of that
%              name. A name that the library lacks needs neutral, limits, and
%              variables or, with laboratory = true, transform.
%   FOLDERS    text or cell of folders that are looked in before the library
%   MODELVARS  scalar struct of loadInput; ASSIGN  cell of names. An effect may
%              share a variable with MODELVARS where its neutral value is the
%              same, never with ASSIGN or with another effect.
%   EFFECTS    1 x e struct array with the fields of describeEffect, [] where
%              LIST is empty or has faults
%   P          1 x n faults, see checkFault; not asked for, the first is thrown
%
% Reasons: effectCanChange badEffects unknownField badEffectName reservedName duplicateEffect
% unknownEffect brokenEffect overwrittenVariable duplicateEffectVariable, and
% those of checkEffectNumbers
%
% See also: getEffect, listEffects, loadEffects
function [effects, p] = resolveEffects (list, folders, modelVars, assign)
  if nargin < 4
    [modelVars, assign] = deal (struct (), {});
  end
  if nargin < 2
    folders = {};
  end
  [p, entries] = asEntries (list);
  [~, library] = listEffects (folders);
  [names, fields, complete] = deal ({});
  for k = 1:numel (entries)
    field = sprintf ('effects(%d)', k);
    [q, entry] = checkEntry (entries{k}, field, names);
    p = [p, q];
    if isstruct (entry)
      names{end + 1} = entry.name;
      [q, entry] = fromLibrary (entry, field, library);
      p = [p, q];
      if isempty (q)
        p = [p, checkEffectNumbers(entry, field)];
        fields{end + 1} = [field, '.variables'];
        complete{end + 1} = entry;
      end
    end
  end
  p = [p, checkShared(complete, fields, modelVars, assign)];
  effects = [];
  if isempty (p)
    effects = cellfun (@describeEffect, complete, 'UniformOutput', false);
    effects = [effects{:}];
    % as the runs with them will be made
    for k = 1:numel (effects)
      effects(k).neutral = toDigits (effects(k).neutral);
      effects(k).limits = toDigits (effects(k).limits);
    end
  elseif nargout < 2
    error (p(1).id, 'resolveEffects: %s', p(1).message);
  end
end

function [p, entries] = asEntries (list)
  p = checkFault ();
  entries = {};
  if isKind ('nothing', list)
    return
  elseif isKind ('text', list)
    entries = {list};
  elseif isstruct (list)
    entries = num2cell (list(:)');
  elseif iscell (list)
    entries = list(:)';
  else
    p = badEntry ('effects', '[], or a struct array', list);
  end
end

function p = badEntry (field, expected, got)
  p = checkFault ('badEffects', field, ...
                  [expected, ' with at least the field name'], ...
                  describeValue (got), ...
                  'Take loadEffects.m of the toolbox as a pattern.');
end

% ENTRY comes back as a struct with a good name and without empty fields, or
% as [].
function [p, entry] = checkEntry (entry, field, names)
  if ischar (entry)
    entry = struct ('name', entry);
  end
  if ~isKind ('struct', entry) || ~isfield (entry, 'name')
    p = badEntry (field, 'a name, or a struct', entry);
    entry = [];
    return
  end
  known = {'name', 'variables', 'neutral', 'limits', 'saysName', 'laboratory', 'transform'};
  change = {'canChange', 'effectCanChange', '''yes'', ''unlikely'' or ''no''', ...
            @(v) any (strcmp (v, {'yes', 'unlikely', 'no'})), 'other', ...
            false, 'Say whether it can differ from the reference.'};
  isText = @(v) ischar (v) && rows (v) <= 1;
  texts = {'label', 'unit', 'group', 'question', 'source'}';
  rule = @(names, expected, isGood, cure) ...
           [names, repmat({'badEffects', expected, isGood, 'other', false, cure}, ...
                          numel (names), 1)];
  rules = [change; rule(texts, 'a text', isText, 'Write it in quotes.'); ...
           rule({'benches'; 'confusedWith'; 'kinds'}, 'a cell of texts', @iscellstr, ...
                'Write it in quotes, in braces.'); ...
           rule({'priorScale'}, 'positive numbers, one a variable', ...
                @(v) isnumeric (v) && isreal (v) && all (v > 0), 'Or leave it out.')];
  p = [checkFields(entry, field, known, rules), ...
       checkEffectName(entry.name, [field, '.name'], names)];
  if ~isKind ('name', entry.name)
    entry = [];
    return
  end
  isGiven = structfun (@(value) ~isKind ('nothing', value), entry);
  entry = rmfield (entry, fieldnames (entry)(~isGiven));
end

function p = checkEffectName (name, field, names)
  p = checkFault ();
  if ~isKind ('name', name)
    p = checkFault ('badEffectName', field, ...
                    'a name of letters, digits and _', ...
                    describeValue (name), 'Write a short name.');
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
function [p, entry] = fromLibrary (entry, field, library)
  p = checkFault ();
  if any (strcmp (entry.name, {library.name}))
    try
      base = getEffect (entry.name, library);
    catch err
      p = checkFault ('brokenEffect', [field, '.name'], ...
                      sprintf ('a library file of %s that runs', ...
                               entry.name), regexprep (err.message, '\s+', ' '), ...
                      'Call getEffect at the Octave prompt until it runs.');
      return
    end
    if isfield (entry, 'limits') && ~isfield (entry, 'priorScale')
      base = rmfield (base, 'priorScale');
    end
    entry = mergeFields (base, entry);
    entry.oneSided = actsBothWays (base) && ~actsBothWays (entry);
  elseif ~any (isfield (entry, {'variables', 'neutral', 'limits'}))
    cure = checkNearest (entry.name, {library.name});
    if isempty (cure)
      cure = 'Give it variables, neutral and limits.';
    end
    p = checkFault ('unknownEffect', [field, '.name'], ...
                    'an effect of the library, or one with variables', ...
                    entry.name, cure);
  end
end

function yes = actsBothWays (e)
  yes = any (min (e.limits, [], 1) < e.neutral & e.neutral < max (e.limits, [], 1));
end

function p = checkShared (entries, fields, modelVars, assign)
  p = checkFault ();
  earlier = {};
  hasNames = @(e) isfield (e, 'variables') && iscell (e.variables);
  for k = find (cellfun (hasNames, entries))
    names = entries{k}.variables(:)';
    neutral = NaN (1, numel (names));
    if isfield (entries{k}, 'neutral') && ...
        isequal (size (entries{k}.neutral), size (neutral))
      neutral = entries{k}.neutral;
    end
    for j = find (cellfun (@(n) isKind ('name', n), names))
      p = [p, checkVariable(names{j}, neutral(j), fields{k}, ...
                            earlier, modelVars, assign)];
      earlier = [earlier, names(j)];
    end
  end
end

function p = checkVariable (name, neutral, field, earlier, modelVars, assign)
  p = checkFault ();
  if any (strcmp (name, earlier))
    p = checkFault ('duplicateEffectVariable', field, ...
                    'variables of no other effect', name, ...
                    'Give each effect a variable of its own.');
  elseif any (strcmp (name, assign))
    p = checkFault ('overwrittenVariable', field, ...
                    'variables that are not calibrated', ...
                    [name, ', which assign names too'], ...
                    'Take it out of assign or out of effects.');
  elseif isfield (modelVars, name) && ~isequal (modelVars.(name), neutral)
    p = checkFault ('overwrittenVariable', field, ...
                    ['neutral values as in modelVars: ', ...
                     describeValue(modelVars.(name))], ...
                    [name, ' with ', describeValue(neutral)], ...
                    'Take it out of modelVars.');
  end
end

%!shared e
%! e = struct ('name', 'lid', 'variables', {{'k'}}, 'neutral', 0, ...
%!             'limits', [0; 1e5]);
%!function ids = idsOf (varargin)
%!  [~, p] = resolveEffects (varargin{:});
%!  ids = strrep ({p.id}, 'DEcalioc:checkCase:', '');
%!endfunction
%!test
%! % limits that leave out a side on which the library has values
%! sides = @(limits) resolveEffects (struct ('name', 'meanSize', 'limits', limits)).oneSided;
%! assert ([sides([1; 1.4]), sides([0.9; 1.4]), sides([])], [true, false, false]);
%! assert (! resolveEffects ('shape').oneSided);
%!test
%! [~, p] = resolveEffects (e, {}, struct ('k', 0), {'a'});
%! assert (isempty (p));
%!assert (idsOf ('tlt'), {'unknownEffect'})
%!assert (idsOf (setfield (e, 'canChange', 'maybe')), {'effectCanChange'})
%!assert (idsOf (setfield (e, 'name', 'unlisted')), {'reservedName'})
%!assert (idsOf (setfield (e, 'unit', 5)), {'badEffects'})
%!assert (idsOf (setfield (e, 'priorScale', -3)), {'badEffects'})
%!assert (idsOf (setfield (e, 'kinds', 'mass')), {'badEffects'})
%!assert (idsOf (e, {}, struct (), {'k'}), {'overwrittenVariable'})
%!assert (idsOf (e, {}, struct ('k', 3), {}), {'overwrittenVariable'})
%!assert (idsOf ([e, e]), {'duplicateEffect', 'duplicateEffectVariable'})
%!assert (isempty (resolveEffects ([])) && isempty (resolveEffects ({})))
%!test
%! % a name, a name with limits, an effect of one's own in four fields
%! found = resolveEffects ({'cohesion', struct('name', 'tilt', 'limits', ...
%!                                             [0; 1], 'unit', ''), e});
%! assert ({found.name}, {'cohesion', 'tilt', 'lid'});
%! assert (found(2).limits, [0; 1]);
%! assert (found(2).priorScale, 2);
%! assert (found(2).variables, {'tiltAngle'});
%! assert (found(2).unit, 'deg');
%! assert (found(3).group, 'lid');
%!test
%! % an effect of the laboratory of one's own
%! zero = struct ('name', 'zero', 'laboratory', true, 'neutral', 0, ...
%!                'limits', [-1; 1], 'transform', @(Z, s, info) Z + s);
%! assert (resolveEffects (zero).transform (1, 2, []), 3);
%!error id=DEcalioc:checkCase:badEffects resolveEffects (7)

% SPDX-License-Identifier: GPL-3.0-only
