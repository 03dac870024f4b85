% EDITSCRIPTS  Makes numbers of LIGGGHTS scripts variables of a model.
%
% CALL: [TEXTS, NAMES, NOTES] = editScripts (TEXTS, NAMES, SEED)
%
%   TEXTS  1 x s cell of scripts; back as a model has them
%   NAMES  1 x n cell: variables, or entries of fix property/global (see
%          scriptProperty), which become ${VARIABLE}; back as names of variables
%   SEED   variable of the packing's seed (text); '': runSeed, which is put in
%          place of the number that seeds the one fix insert there is
%   NOTES  1 x k cell of sentences: what is not as it was
%
% "variable NAME equal" of a name that is handed over becomes "index", which
% -var can set, where the scripts set it once.
%
% Errors: those of scriptProperty

function [texts, names, notes] = editScripts (texts, names, seed)
  notes = cell (1, 0);
  for k = 1:numel (names)
    if isProperty (names{k}, texts)
      name = names{k};
      [texts, names{k}, was] = scriptProperty (texts, name);
      notes{end + 1} = sprintf (['%s is ${%s} in the scripts of the model, ' ...
                                 'where it was %s'], name, names{k}, ...
                                strjoin (was, ' and '));
    end
  end
  for name = [names, repmat({seed}, 1, ~isempty (seed))]
    [texts, note] = asIndex (texts, name{1});
    notes = [notes, note];
  end
  if isempty (seed)
    [texts, note] = withSeed (texts);
    notes = [notes, note];
  end
end

function yes = isProperty (name, texts)
  isName = ~isempty (regexp (name, '^[A-Za-z_]\w*$', 'once'));
  isUsed = @(text) ~isempty (regexp (text, ['\{', name, '\}|v_', name, '\>|', ...
                                            'variable[ \t]+', name, '\>'], ...
                                     'once'));
  yes = ~isName;
  if isName && ~any (cellfun (isUsed, texts))
    known = scriptProperty (texts);
    yes = any (strcmp (strtok (known), name));
  end
end

function [texts, note] = asIndex (texts, name)
  form = ['^([ \t]*variable[ \t]+', name, '[ \t]+)(?:equal|string)\>'];
  found = regexp (texts, form, 'match', 'lineanchors');
  note = cell (1, 0);
  if sum (cellfun (@numel, found)) == 1
    texts = regexprep (texts, form, '$1index', 'lineanchors');
    note = {sprintf(['variable %s has the style index in the scripts of the ' ...
                     'model: LIGGGHTS takes no other from outside'], name)};
  end
end

function [texts, note] = withSeed (texts)
  note = cell (1, 0);
  found = cellfun (@seedsOf, texts, 'UniformOutput', false);
  s = find (~cellfun (@isempty, found));
  isUsed = ~cellfun (@isempty, strfind (texts, '${runSeed}'));
  if isscalar ([found{:}]) && ~any (isUsed)
    place = found{s};
    text = texts{s};
    number = regexp (text(place:end), '^\d+', 'match', 'once');
    texts{s} = [text(1:place - 1), '${runSeed}', ...
                text(place + numel (number):end)];
    note = {['the seed ', number, ' of fix insert is ${runSeed} in the ', ...
             'scripts of the model: each run has a packing of its own']};
  end
end

% Where the numbers stand that seed a fix insert.
function places = seedsOf (text)
  gap = '(?:[ \t]|&[ \t]*\r?\n)+';
  places = [];
  starts = regexp (text, ['^[ \t]*fix', gap, '\S+', gap, '\S+', gap, 'insert/'], ...
                   'end', 'lineanchors');
  for first = starts
    rest = regexp (text(first:end), '^(?:[^\n&#]|&[ \t]*\r?\n)*', 'match', 'once');
    at = regexp (rest, ['\sseed', gap, '(\d+)'], 'tokenExtents', 'once');
    places = [places, first - 1 + at(1:1 - isempty (at))];
  end
end

%!shared script
%! script = ["variable mu equal 0.3 # x\n# fix i all insert/pack seed 5\n", ...
%!           "fix i all insert/pack &\n  seed 16561 distributiontemplate d\n", ...
%!           "fix f all property/global coefficientFriction peratomtypepair ", ...
%!           "1 0.5\nprint \"${mu}\"\n"];
%!test
%! [t, names, notes] = editScripts ({script}, {'friction 1-1', 'mu'}, '');
%! assert (names, {'friction_1_1', 'mu'});
%! assert (numel (notes), 3);
%! for part = {'variable mu index 0.3 # x', "&\n  seed ${runSeed} distr", ...
%!             'pair 1 ${friction_1_1}', '# fix i all insert/pack seed 5'}
%!   assert (! isempty (strfind (t{1}, part{1})), part{1});
%! end
%!test
%! % a seed that the script has, two fixes, two values of a variable: as they are
%! two = [script, script];
%! [t, ~, notes] = editScripts ({two}, {'mu'}, '');
%! assert ({t, notes}, {{two}, cell(1, 0)});
%! own = strrep (strrep (script, '16561', '${runSeed}'), 'mu equal', 'mu index');
%! [t, ~, notes] = editScripts ({own}, {'mu'}, '');
%! assert ({t, notes}, {{own}, cell(1, 0)});
%!test
%! % a property with one value needs no type
%! one = 'fix v all property/global yieldRatio scalar 0.1';
%! [t, names] = editScripts ({one, ''}, {'yieldRatio'}, 'seed');
%! assert (t{1}, 'fix v all property/global yieldRatio scalar ${yieldRatio}');
%!error id=DEcalioc:scriptProperty:unknownName
%! editScripts ({script}, {'friction 1-2'}, '');

% SPDX-License-Identifier: GPL-3.0-only
