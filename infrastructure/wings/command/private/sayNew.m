% SAYNEW  Makes a case, or a model of one's own, and says how to go on.
%
% CALL: STATUS = sayNew (ROOT, FOLDER, ARGS)
%
%   ROOT    folder of the toolbox (text)
%   FOLDER  folder in which it was called (text)
%   ARGS    cell of texts, see decalioc new --help
%   STATUS  0
%
% Nothing that is there is overwritten; what a killed call has left out is made
% by the next one.
%
% Errors: DEcalioc:sayNew:missingField, :badValue, :exists, :cannotWrite; those
% of commandOptions, fillTemplate and newScriptModel

function status = sayNew (root, folder, args)
  status = 0;
  spec = struct ('model', 'one', 'bench', 'one', 'curve', 'flag', 'script', 'one', ...
                 'vary', 'many', 'set', 'many', 'target', 'many', ...
                 'output', 'one', 'mean', 'one', 'seed', 'one', 'post', 'one');
  if any (strncmp (args, '--script', 8))
    spec.curve = 'many';
  end
  [given, words] = commandOptions (args, spec);
  if ~isempty (given.script)
    given.script = absoluteFrom (folder, given.script);
    if ~isempty (given.post)
      given.post = absoluteFrom (folder, given.post);
    end
    given.curve = cellfun (@(text) withPath (text, folder), given.curve, ...
                           'UniformOutput', false);
  end
  target = placeOf (given, words, folder);
  asks = isempty (given.model) && strcmp (getenv ('DECALIOC_ASKS'), 'yes');
  if asks && isempty (given.bench)
    given.bench = askBench (root);
  end
  isCase = isfile (fullfile (target, 'loadInput.m'));
  if isempty (given.model)
    refuseIf (isCase, target, 'is a case already');
  end
  if ~isempty (given.bench)
    words = wordsOfBench (root, given.bench, asks);
    makePlace (target);
    makeForm (fullfile (root, 'templates', 'benchCase'), target, words);
    if asks
      printf ("\nTaken, for you to change:\n%s\n", words.TAKEN);
    end
  elseif isempty (given.model)
    makePlace (target);
    copyNew (root, target, {'loadEffects.m', 'loadInput.m'});
    printf (['This is the case of the publication, a container of 1,200 ' ...
             'grains that is lifted.\nFor your own grains: decalioc new ' ...
             '--bench Heap,Drum FOLDER takes test rigs of the toolbox ' ...
             '(decalioc benches\ndescribes them), decalioc new --model ' ...
             'NAME makes a model of your own to be edited.\n\n']);
  else
    model = fullfile (target, 'DEMmodels', given.model);
    refuseIf (isCase && isfolder (model), model, 'is there already');
    makeModel (root, target, model, given);
  end
  sayMade (target, given, isCase);
end

function target = placeOf (given, words, folder)
  checkModel (given);
  if isempty (words) && isempty (given.model) || numel (words) > 1
    error ('DEcalioc:sayNew:missingField', ...
           ['one FOLDER for the case is needed, got %d. decalioc new ' ...
            '--help shows the call.'], numel (words));
  end
  words{end + 1} = given.model;
  target = absoluteFrom (folder, words{1});
end

function checkModel (given)
  if ~isempty (given.model) && ~isKind ('folder', given.model)
    error ('DEcalioc:sayNew:badValue', ...
           ['--model must be a plain name (letters, digits, _ - + .), got ' ...
            '%s.'], given.model);
  elseif ~isempty (given.script) && isempty (given.model)
    error ('DEcalioc:sayNew:missingField', ...
           '--script needs a name for the model: --model NAME.');
  elseif ~isempty (given.bench) && ~isempty (given.model)
    error ('DEcalioc:sayNew:badValue', ...
           ['--bench takes test rigs of the toolbox as they are, --model ' ...
            'makes a model of your own: give one of the two.']);
  elseif isequal (given.curve, true) && isempty (given.model)
    error ('DEcalioc:sayNew:badValue', ...
           ['--curve goes with --model NAME; with --script, too, it names the ' ...
            'curve: --curve time:force=points.csv.']);
  elseif isempty (given.script)
    refuseUnread (given);
  end
end

% PLACE:NAME=FILE, the file from the folder of the call.
function text = withPath (text, folder)
  [name, file] = strtok (text, '=');
  if numel (file) > 1
    text = [name, '=', absoluteFrom(folder, file(2:end))];
  end
end

% What only the model of a script takes would be lost without a word.
function refuseUnread (given)
  names = {'vary', 'set', 'target', 'output', 'mean', 'seed', 'post'};
  names = names(~cellfun (@(n) isempty (given.(n)), names));
  if ~isempty (names)
    error ('DEcalioc:sayNew:missingField', ...
           ['--vary, --set, --target, --output, --mean, --seed and --post go with ' ...
            '--script FILE, got --%s without it. Add --script FILE, or leave these ' ...
            'out and edit loadInput.m of the case.'], ...
           strjoin (names, ', --'));
  end
end

function refuseIf (isBad, path, why)
  if isBad
    error ('DEcalioc:sayNew:exists', ...
           '%s %s. Nothing is overwritten; take another name.', path, why);
  end
end

function makePlace (target)
  [isMade, why] = mkdir (target);
  if ~isMade
    error ('DEcalioc:sayNew:cannotWrite', ...
           ['decalioc new: %s must be a folder that can be made, got: %s. ' ...
            'Choose a folder of your own.'], target, why);
  end
end

function copyNew (root, target, names)
  for name = names
    file = fullfile (target, name{1});
    if ~isfile (file)
      tidyDrafts (target, -1, name{1});    % what a killed call has left
      writeAtomic (file, fileread (fullfile (root, name{1})));
    end
  end
end

function makeModel (root, target, model, given)
  isThere = isfolder (model);
  template = 'case';
  notes = {};
  if ~isempty (given.script)
    template = 'scriptCase';
    if isThere
      % of a call that was killed: the script's words are needed all the same
      place = privateFolder ();
      tidy = onCleanup (@() system (['rm -rf ', shellQuote(place)]));
      model = fullfile (place, 'model');
    end
    [words, notes] = newScriptModel (root, model, given);
    if ~isempty (given.curve)
      template = 'scriptCurveCase';
    end
  elseif ~isThere
    newTemplateModel (root, model, given);
  end
  if isequal (given.curve, true)
    template = fullfile ('curve', 'case');
  end
  words.MODEL = given.model;
  if ~isfile (fullfile (target, 'loadInput.m'))
    makeForm (fullfile (root, 'templates', template), target, words);
  end
  copyNew (root, target, {'loadEffects.m'});
  cellfun (@(note) printf ('NOTE: %s\n', note), notes);
end

function newTemplateModel (root, model, given)
  place = privateFolder ();
  tidy = onCleanup (@() system (['rm -rf ', shellQuote(place)]));
  draft = fullfile (place, 'draft');
  fillTemplate (fullfile (root, 'templates', 'model'), draft, ...
                struct ('MODEL', given.model));
  if given.curve
    writeAtomic (fullfile (draft, 'results.csv'), ...
                 fileread (fullfile (root, 'templates', 'curve', 'model', ...
                                     'results.csv')));
  end
  fillTemplate (fullfile (root, 'infrastructure', 'effects', 'liggghts'), ...
                fullfile (draft, 'effects'), struct ());
  fillTemplate (draft, model, struct ());
end

% The form comes last: with it the folder is a case.
function makeForm (template, target, words)
  place = privateFolder ();
  tidy = onCleanup (@() system (['rm -rf ', shellQuote(place)]));
  draft = fullfile (place, 'draft');
  fillTemplate (template, draft, words);
  last = 'loadInput.m';
  names = setdiff (readdir (draft)', {'.', '..', last});
  copyNew (draft, target, [names, {last}]);
end

function bench = askBench (root)
  sayBenches (root, '', {});
  bench = askPerson (['test rigs, with commas between (none: the published ' ...
                      'container)'], 'Heap', @(text) deal (text, '', ''));
  if strcmp (bench, 'none')
    bench = '';
  end
end

function words = wordsOfBench (root, bench, asks)
  if asks
    printf ("Enter takes what stands in brackets, back returns to the question before.\n");
    words = askInTurn (@(ask) newBenchCase (root, bench, ask), @askPerson);
  else
    printf ("Nothing is asked, as this is no terminal: sizes and grains as they come.\n");
    words = newBenchCase (root, bench);
  end
end

function sayMade (target, given, wasCase)
  if ~isempty (given.model)
    printf ('model  %s\n', fullfile (target, 'DEMmodels', given.model));
  end
  if wasCase
    printf (['The case has its loadInput.m already: name the model there, ' ...
             'Input.model{k} = ''%s''.\n'], given.model);
  else
    printf ('case   %s\n', target);
  end
  place = shellQuote (target);
  if isempty (regexp (target, '[^\w./+-]', 'once'))
    place = target;
  end
  printf (['\nNext:  decalioc check --try %s\n       decalioc run %s\n' ...
           '       decalioc report %s\n'], place, place, place);
end

%!shared root, base
%! root = fileparts (fileparts (which ('startToolbox')));
%! base = emptyFolder ();
%!function text = quietly (varargin)
%!  text = evalc ('sayNew (varargin{:})');
%!endfunction
%!test
%! % a form; a second call changes nothing
%! text = quietly (root, base, {'plain case'});
%! there = fullfile (base, 'plain case');
%! assert (~isempty (strfind (text, ['check --try ''', there, ''''])));
%! assert (isfile (fullfile (there, 'loadInput.m')));
%!error id=DEcalioc:sayNew:exists sayNew (root, base, {'plain case'});
%!test
%! % a model: its name is in the files; what a killed call left out comes later
%! place = fullfile (base, 'my case');
%! quietly (root, base, {'--model', 'Mine', place});
%! model = fullfile (place, 'DEMmodels', 'Mine');
%! assert (~isempty (strfind (fileread (fullfile (model, 'in.Mine')), 'Mine')));
%! assert (isfile (fullfile (model, 'effects', 'material.inc')));
%! [~, left] = system (['grep -rl "@MODEL@" ', shellQuote(place)]);
%! assert (left, '');
%! unlink (fullfile (place, 'loadInput.m'));
%! fclose (fopen (draftName (fullfile (place, 'loadInput.m')), 'w'));
%! writeAtomic (fullfile (model, 'mark'), 'edited');
%! quietly (root, base, {'--model', 'Mine', place});
%! assert (isfile (fullfile (place, 'loadInput.m')));
%! assert (isempty (glob (fullfile (place, '*.tmp'))));
%! assert (isfile (fullfile (model, 'mark')));
%! % with a curve
%! quietly (root, base, {'--model', 'Curve', '--curve', ...
%!                       fullfile(base, 'c')});
%! folder = fullfile (base, 'c');
%! names = {resultInfo(fullfile (folder, 'DEMmodels', 'Curve')).name};
%! assert (names{end}, 'profile');
%! table = readMeasured (fullfile (folder, 'measured.csv'), {'Curve'});
%! assert (sum (strcmp ({table.series}, 'profile')), 5);
%! % a second model in the same case
%! text = quietly (root, base, {'--model', 'Other', place});
%! assert (~isempty (strfind (text, 'has its loadInput.m already')));
%!test
%! % test rigs of the toolbox: the input is whole but for what was measured
%! place = fullfile (base, 'rigs');
%! quietly (root, base, {'--bench', 'Heap,Drum', place});
%! file = fullfile (place, 'measured.csv');
%! [header, cells] = readCsvTable (file);
%! at = strcmp (header, 'value');
%! assert (rows (cells), 13);
%! assert (all (cellfun (@isempty, cells(:, at))));
%! [status, text] = startCommand (place, 'check');
%! assert (status, 1);
%! assert (~isempty (strfind (text, 'measured.csv')), text);
%! text = strrep (fileread (file), 'Heap,slope,,', 'Heap,slope,31,');
%! writeAtomic (file, strrep (text, 'Drum,slope1,,', 'Drum,slope1,36,'));
%! [status, text] = startCommand (place, 'check');
%! assert (status, 0);
%!error id=DEcalioc:sayNew:badValue ...
%! sayNew (root, base, {'--bench', 'Heap', '--model', 'M'});
%!error id=DEcalioc:listBenches:unknownName ...
%! sayNew (root, base, {'--bench', 'Heep', 'x'});
%!error id=DEcalioc:sayNew:missingField sayNew (root, base, {});
%!error id=DEcalioc:sayNew:missingField sayNew (root, base, {'a', 'b'});
%!error id=DEcalioc:sayNew:badValue sayNew (root, base, {'--curve', 'x'});
%!error id=DEcalioc:sayNew:missingField sayNew (root, base, {'--script', 'x'});
%!error id=DEcalioc:sayNew:badValue sayNew (root, base, {'--model', '../x'});
%!test
%! % places where no folder can be made
%! file = fullfile (base, 'a file');
%! writeAtomic (file, 'x');
%! for place = {fullfile(file, 'x'), file, '/proc/x'}
%!   text = '';
%!   try
%!     sayNew (root, base, place);
%!   catch err
%!     text = [err.identifier, err.message];
%!   end
%!   assert (strncmp (text, 'DEcalioc:sayNew:cannotWrite', 27), text);
%!   assert (~isempty (strfind (text, [place{1}, ' must be a folder that'])));
%!   assert (~isempty (strfind (text, 'Choose a folder of your own')));
%! end
%! assert (fileread (file), 'x');
%!test
%! % what would be read by nothing
%! unread = {'--vary', 'mu=0.2:0.8'; '--set', 'density=2'; ...
%!           '--target', 'a=1'; '--output', 'out'; '--seed', 'seed'};
%! for pair = unread'
%!   text = '';
%!   try
%!     sayNew (root, base, [{'--model', 'Unread'}, pair']);
%!   catch err
%!     text = [err.identifier, err.message];
%!   end
%!   assert (strncmp (text, 'DEcalioc:sayNew:missingField', 28), text);
%!   assert (~isempty (strfind (text, ['got ', pair{1}, ' without'])), text);
%! end
%! assert (~isfolder (fullfile (pwd (), 'Unread')));

% SPDX-License-Identifier: GPL-3.0-only
