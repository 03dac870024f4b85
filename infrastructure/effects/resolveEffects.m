% RESOLVEEFFECTS  Completes the user's list of candidate effects.
%
% CALL: EFFECTS = resolveEffects (LIST)
%       EFFECTS = resolveEffects (LIST, FOLDERS)
%
% LIST     what loadEffects gives: [] or {}; a name; a cell of names and
%          structs; a struct array. A struct needs a name; what it does not
%          give (or gives empty) comes from the library's file of that name. A
%          name that the library lacks needs neutral, limits, and variables
%          or, with laboratory = true, transform.
% FOLDERS  text or cell of folders that are looked in before the library
% EFFECTS  1 x e struct array with the fields of describeEffect, [] if LIST is
%          empty
%
% Throws DEcalioc:resolveEffects:unknownName, DEcalioc:resolveEffects:badType,
% DEcalioc:resolveEffects:badValue (a name or a variable twice).
%
% See also: getEffect, listEffects, loadEffects
function effects = resolveEffects (list, folders)
  if nargin < 2
    folders = {};
  end
  entries = asCell (list);
  known = listEffects (folders);
  effects = [];
  for k = 1:numel (entries)
    effects = [effects, complete(entries{k}, known, folders)];
  end
  checkUnique (effects);
end

function entries = asCell (list)
  if isempty (list)
    entries = {};
  elseif ischar (list)
    entries = {list};
  elseif isstruct (list)
    entries = num2cell (list(:).');
  elseif iscell (list)
    entries = list(:).';
  else
    error ('DEcalioc:resolveEffects:badType', ...
           ['resolveEffects: LIST must be a cell of names and structs or a ' ...
            'struct array, got %s.'], class (list));
  end
end

function effect = complete (entry, known, folders)
  if ischar (entry)
    entry = struct ('name', entry);
  end
  if ~isstruct (entry) || ~isfield (entry, 'name') || ~ischar (entry.name)
    error ('DEcalioc:resolveEffects:badType', ...
           'resolveEffects: each entry of LIST must be a name or have one.');
  end
  given = fieldnames (entry);
  empty = structfun (@isempty, entry);
  entry = rmfield (entry, given(empty & ~strcmp (given, 'name')));
  if any (strcmp (known, entry.name))
    base = getEffect (entry.name, folders);
    if isfield (entry, 'limits') && ~isfield (entry, 'priorScale')
      base = rmfield (base, 'priorScale');
    end
    entry = mergeFields (base, entry);
  elseif ~all (isfield (entry, {'neutral', 'limits'})) || ...
         ~any (isfield (entry, {'variables', 'transform'}))
    error ('DEcalioc:resolveEffects:unknownName', ...
           ['resolveEffects: %s is not in the library (%s), so it must ' ...
            'have neutral, limits, and variables or (of the laboratory) ' ...
            'transform.'], entry.name, strjoin (known, ', '));
  end
  effect = describeEffect (entry);
end

function checkUnique (effects)
  if isempty (effects)
    return
  end
  names = {effects.name};
  variables = [effects.variables];
  isTwice = @(texts) numel (unique (texts)) < numel (texts);
  if isTwice (names) || isTwice (variables)
    error ('DEcalioc:resolveEffects:badValue', ...
           ['resolveEffects: names and variables of the effects must ' ...
            'differ, got %s with %s.'], strjoin (names, ', '), ...
           strjoin (variables, ', '));
  end
end

%!assert (isempty (resolveEffects ([])))
%!assert (isempty (resolveEffects ({})))

%!test % a name, a name with limits, an effect of one's own in four fields
%! own = struct ('name', 'lid', 'variables', {{'lidMass'}}, 'neutral', 0, ...
%!               'limits', [0; 3]);
%! near = struct ('name', 'tilt', 'limits', [0; 1]);
%! e = resolveEffects ({'cohesion', near, own});
%! assert ({e.name}, {'cohesion', 'tilt', 'lid'});
%! assert (e(2).limits, [0; 1]);
%! assert (e(2).priorScale, 2);
%! assert (e(2).variables, {'tiltAngle'});
%! assert (e(3).group, 'lid');

%!test % an effect of the laboratory of one's own
%! own = struct ('name', 'zero', 'laboratory', true, 'neutral', 0, ...
%!               'limits', [-1; 1], 'transform', @(Z, s, info) Z + s);
%! assert (resolveEffects (own).transform (1, 2, []), 3);

%!test % a struct array with empty fields
%! list = struct ('name', {'tilt', 'drag'}, 'limits', {[], [0; 5]});
%! e = resolveEffects (list);
%! assert (e(1).limits, getEffect ('tilt').limits);
%! assert (e(2).limits, [0; 5]);

%!error id=DEcalioc:resolveEffects:unknownName resolveEffects ({'noSuchEffect'})
%!error id=DEcalioc:resolveEffects:badType resolveEffects (7)
%!error id=DEcalioc:resolveEffects:badValue resolveEffects ({'tilt', 'tilt'})
