% GETEFFECT  Description of one effect of the library.
%
% CALL: EFFECT = getEffect (NAME)
%       EFFECT = getEffect (NAME, FOLDERS)
%
% NAME     name of the effect, as listEffects gives it
% FOLDERS  text or cell of folders that are looked in before the library, or the
%          LIBRARY that listEffects gives
% EFFECT   scalar struct, see describeEffect, which fills in what a row or a file
%          leaves out
%
% Throws DEcalioc:getEffect:unknownName, DEcalioc:getEffect:badValue,
% DEcalioc:getEffect:badFile.
%
% See also: describeEffect, listEffects, resolveEffects
function effect = getEffect (name, folders)
  if nargin < 2
    folders = {};
  end
  library = folders;
  if ~isstruct (folders)
    [~, library] = listEffects (folders);
  end
  entry = library(strcmp ({library.name}, name));
  if isempty (entry)
    error ('DEcalioc:getEffect:unknownName', ...
           'getEffect: NAME must be one of %s, got %s.', ...
           strjoin ({library.name}, ', '), name);
  elseif isempty (entry.row)
    effect = ofFunction (name, entry.file);
  else
    effect = ofRow (entry.row, entry.file);
  end
end

% What the function of a user does not give is filled in.
function effect = ofFunction (name, file)
  [folder, base] = fileparts (file);
  if ~any (strcmp (strsplit (path (), pathsep ()), folder))
    addpath (folder);
    restore = onCleanup (@() rmpath (folder));
  end
  try
    effect = feval (base);
  catch err
    error ('DEcalioc:getEffect:badFile', 'getEffect: %s must run, got: %s', ...
           file, err.message);
  end
  if ~isstruct (effect) || ~isscalar (effect)
    error ('DEcalioc:getEffect:badFile', ...
           ['getEffect: %s must give a struct with name, variables, neutral and ' ...
            'limits, got %s.'], file, describeValue (effect));
  end
  variables = givenField (effect, 'variables', {});
  if ~iscellstr (variables)
    error ('DEcalioc:getEffect:badFile', ...
           ['getEffect: variables in %s must be a cell of names of variables of data.head, ' ...
            'got %s. Write for example {''cohesionPP''}.'], file, describeValue (variables));
  end
  try
    effect = describeEffect (mergeFields (struct ('name', name), effect));
  catch err
    error (err.identifier, '%s (of %s)', err.message, file);
  end
end

% Several variables of one effect, and their numbers, are parted by blanks.
function effect = ofRow (row, file)
  numbers = @(column) numbersIn (row, column, file);
  given = struct ('name', row.name, 'variables', {strsplit(row.variables)}, ...
                  'neutral', numbers ('neutral'), ...
                  'limits', [numbers('weakest'); numbers('strongest')]);
  for field = {'unit', 'label', 'group', 'usually', 'question', 'source'}
    text = givenField (row, field{1}, '');
    if ~isempty (text)
      given.(field{1}) = text;
    end
  end
  if isfield (given, 'label')
    given.saysName = strcmp (givenField (row, 'saysName', ''), 'yes');
  end
  effect = describeEffect (given);
end

function values = numbersIn (row, column, file)
  values = str2double (strsplit (row.(column)));
  if any (isnan (values)) || numel (values) ~= numel (strsplit (row.variables))
    error ('DEcalioc:getEffect:badValue', ...
           ['getEffect: %s of %s in %s must be a number for each of its ' ...
            'variables (%s), got ''%s''.'], column, row.name, file, ...
           row.variables, row.(column));
  end
end

%!test
%! e = getEffect ('cohesion');
%! assert (e.variables, {'cohesionPP'});
%! assert ({e.neutral, e.limits, e.saysName}, {0, [0; 6e4], true});
%! assert (getEffect ('gain').laboratory);

%!test % each entry of the library describes the effect of its name
%! [names, library] = listEffects ();
%! for name = names
%!   assert (getEffect (name{1}, library).name, name{1});
%! end

%!test % a file in a folder that is not on the path, with four fields only
%! folder = emptyFolder ();
%! file = fullfile (folder, 'effectTrialOfGetEffect.m');
%! writeAtomic (file, ["function e = effectTrialOfGetEffect ()\n", ...
%!   "e = struct ('name', 'trialOfGetEffect', ", ...
%!   "'variables', {{'q'}}, 'neutral', 0, 'limits', [0; 2]);\nend\n"]);
%! e = getEffect ('trialOfGetEffect', folder);
%! delete (file);
%! assert ({e.priorScale, e.group}, {4, 'trialOfGetEffect'});
%! % a row of a table, of two variables; one with a word for a number
%! file = fullfile (folder, 'effects.csv');
%! writeAtomic (file, ["name,variables,neutral,weakest,strongest,unit\n", ...
%!                     "two,a b,0 1,0 1,3 4,m\nbad,a,0,low,1,m\n"]);
%! e = getEffect ('two', folder);
%! assert ({e.variables, e.neutral, e.limits, e.unit, e.saysName}, ...
%!         {{'a', 'b'}, [0, 1], [0, 1; 3, 4], 'm', true});
%! fail ('getEffect (''bad'', folder)', 'weakest of bad .* got ''low''');
%! delete (file);
%! rmdir (folder);

%!test
%! % the four fields alone, a field that is missing, what is no struct
%! [folder, put] = emptyFolder ();
%! lines = {"e = struct ('variables', {{'q'}}, 'neutral', 0, 'limits', [0; 2]);", ...
%!          "e = struct ('variables', {{'q'}}, 'neutral', 0);", 'e = 7;', ...
%!          "e = struct ('variables', 'q', 'neutral', 0, 'limits', [0; 2]);"};
%! for k = 1:4
%!   name = sprintf ('ownOfGetEffect%d', k);
%!   put (['effectO', name(2:end), '.m'], ...
%!        ["function e = effectO", name(2:end), " ()\n", lines{k}, "\nend\n"]);
%! end
%! e = getEffect ('ownOfGetEffect1', folder);
%! assert ({e.group, e.priorScale, e.usually}, {'ownOfGetEffect1', 4, 'yes'});
%! fail ('getEffect (''ownOfGetEffect2'', folder)', 'field limits. .of .*Effect2.m');
%! fail ('getEffect (''ownOfGetEffect3'', folder)', 'Effect3.m must give a struct');

%! fail ('getEffect (''ownOfGetEffect4'', folder)', 'Effect4.m must be a cell .* got ''q''');
%!error id=DEcalioc:getEffect:unknownName getEffect ('noSuchEffect')

% SPDX-License-Identifier: GPL-3.0-only
