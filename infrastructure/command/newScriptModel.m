% NEWSCRIPTMODEL  Makes a model of a LIGGGHTS script that takes -var NAME VALUE.
%
% CALL: [WORDS, NOTES] = newScriptModel (ROOT, TARGET, GIVEN)
%
%   ROOT    folder of the toolbox (text)
%   TARGET  model folder to be made (text)
%   GIVEN   scalar struct: model (name), script (path), output (file with the
%           results, '': output_results), seed ('': runSeed), and cells of texts
%           vary (NAME=LOW:HIGH), set and target (NAME=NUMBER)
%   WORDS   scalar struct of texts for templates/scriptCase
%   NOTES   cell of sentences for the user
%
% Errors: DEcalioc:newScriptModel:missingField (a parameter or a target),
% :badValue, :cannotWrite; DEcalioc:scriptFiles:missingFile; those of
% fillTemplate

function [words, notes] = newScriptModel (root, target, given)
  [names, limits] = namedNumbers (given.vary, '--vary', 2);
  [fixed, values] = namedNumbers (given.set, '--set', 1);
  [results, measured] = namedNumbers (given.target, '--target', 1);
  if isempty (names) || isempty (results)
    error ('DEcalioc:newScriptModel:missingField', ...
           ['--script needs at least one parameter and one measured value, ' ...
            'got %d and %d. For example: --vary mu=0.2:0.8 --target ' ...
            'height=0.0057'], numel (names), numel (results));
  end
  [~, base, ending] = fileparts (given.script);
  seed = givenField (given, 'seed', 'runSeed');
  output = givenField (given, 'output', 'output_results');
  checkWords ([names, fixed], seed, results, output, [base, ending]);
  [files, variables, text] = scriptFiles (given.script);
  files = setdiff (files, output);     % of a trial by hand, no run's own
  chosen = [names, fixed; num2cell([mean(limits, 1), values])];
  variables = mergeFields (variables, struct (chosen{:}));
  words = struct ('MODEL', given.model, 'SCRIPT', [base, ending], ...
                  'SEED', seed, 'OUTPUT', output);
  % the seed of the packing has a name of its own in data.head
  variables = rmfield (variables, intersect (fieldnames (variables), seed));
  makeFolder (root, target, given, words, files, variables, results);
  words = caseWords (words, names, limits, results, measured);
  notes = notesOn (text, words, variables);
end

% These become text of programs: bash, awk, Octave.
function checkWords (variables, seed, results, output, script)
  isName = @(w) ~isempty (regexp (w, '^[A-Za-z_]\w*$', 'once'));
  isPath = @(w) ~isempty (regexp (w, '^(?!-)[\w.+-]+(/[\w.+-]+)*$')) && ...
                isempty (strfind (w, '..'));
  name = 'a variable of the script (letters, digits, _)';
  path = 'a plain path below the run (letters, digits, _ - + . /)';
  rules = {'--vary and --set', variables, isName, name; ...
           '--target', results, @(w) ~any (w < 32), 'one line of text'; ...
           '--seed', {seed}, isName, name; ...
           '--output', {output}, isPath, path; ...
           '--script', {script}, isPath, path};
  for rule = rules'
    bad = rule{2}(~cellfun (rule{3}, rule{2}));
    if ~isempty (bad)
      error ('DEcalioc:newScriptModel:badValue', ...
             '%s must name %s, got %s.', rule{1}, rule{4}, bad{1});
    end
  end
end

% Of texts NAME=NUMBER, or NAME=LOW:HIGH for COUNT 2; COUNT x n numbers.
function [names, numbers] = namedNumbers (texts, option, count)
  names = cell (1, numel (texts));
  numbers = zeros (count, numel (texts));
  for k = 1:numel (texts)
    equals = find (texts{k} == '=', 1, 'last');
    words = strsplit (texts{k}(equals + 1:end), ':');
    values = str2double (words);
    % str2double takes a comma for a separator of thousands: 0,2 would be 2
    if isempty (equals) || equals < 2 || numel (values) ~= count || ...
        ~all (isfinite (values)) || ~isreal (values) || any ([words{:}] == ',')
      error ('DEcalioc:newScriptModel:badValue', ...
             ['%s must be given as %s, got %s. Write numbers with a ' ...
              'decimal point, without commas and units.'], option, ...
             {'NAME=0.3', 'NAME=0.2:0.8'}{count}, texts{k});
    end
    names{k} = texts{k}(1:equals - 1);
    numbers(:, k) = values;
  end
end

% In a draft beside it, so that the model is there whole or not at all.
function makeFolder (root, target, given, words, files, variables, results)
  place = privateFolder ();
  tidy = onCleanup (@() system (['rm -rf ', shellQuote(place)]));
  source = fullfile (place, 'source');
  fillTemplate (fullfile (root, 'templates', 'script'), source, words);
  from = fileparts (make_absolute_filename (given.script));
  for name = [{words.SCRIPT}, files]
    copy = fullfile (source, name{1});
    [~, ~] = mkdir (fileparts (copy));
    [status, why] = system (['cp -L -- ', ...
                             shellQuote(fullfile (from, name{1})), ' ', ...
                             shellQuote(copy), ' 2>&1']);
    if status ~= 0
      error ('DEcalioc:newScriptModel:cannotWrite', ...
             '%s, which the script names, must be copied, got: %s', ...
             name{1}, strtrim (why));
    end
  end
  writeAtomic (fullfile (source, 'data.head'), ...
               ["# Variables of the script, SI units. A run appends its ", ...
                "own values: the\n# last line that names a variable ", ...
                "counts.\n", headLines(variables), ...
                "variable runSeed equal 10007    # a prime above 10,000\n"]);
  writeAtomic (fullfile (source, 'results.csv'), ...
               ["name,kind,unit,series,at,text\n", ...
                sprintf("%s,length,,,,\n", results{:})]);
  fillTemplate (source, target, struct ());
end

function words = caseWords (words, names, limits, results, measured)
  list = @(values) sprintf ('%.10g, ', values)(1:end - 2);
  quoted = @(texts) ['''', strjoin(strrep (texts, '''', ''''''), ...
                                   ''', '''), ''''];
  words.SAMPLES = sprintf ('%d', 2 * numel (names) + 6);
  words.NAMES = quoted (results);
  words.VALUES = list (measured);
  words.TOLS = list (0.05 * ones (size (measured)));
  words.ASSIGN = quoted (names);
  words.LOW = list (limits(1, :));
  words.HIGH = list (limits(2, :));
  % templates/scriptCase/loadInput.FORM is no program before it is filled in
  words.FORM = 'm';
end

function notes = notesOn (text, words, variables)
  isUsed = @(name) ~isempty (regexp (text, ['(\$\{|v_)', name, '\>'], 'once'));
  notes = {['the script does not use ${', words.SEED, '}: all its packings ' ...
            'will be the same one. Put it there as the seed of fix insert, ' ...
            'or name its variable with --seed.'], ...
           ['the script does not end with print "RUN COMPLETE": a run that ' ...
            'breaks off may then be taken for a whole one.']};
  notes = notes([~isUsed(words.SEED), isempty(strfind (text, 'RUN COMPLETE'))]);
  for name = fieldnames (variables)'
    if ~isUsed (name{1})
      notes{end + 1} = ['the script does not use ${', name{1}, '}: it will ' ...
                        'change nothing.'];
    end
    again = ['^[ \t]*variable[ \t]+', name{1}, '[ \t]+equal'];
    if ~isempty (regexp (text, again, 'once', 'lineanchors'))
      notes{end + 1} = ['the script sets ', name{1}, ' itself, as a ' ...
                        'variable of style equal: LIGGGHTS will stop. ' ...
                        'Write index for equal there.'];
    end
  end
end

%!shared folder, given, root
%! root = fileparts (fileparts (which ('startToolbox')));
%! folder = tempname ();
%! mkdir (fullfile (folder, 'meshes'));
%! put = @(name, text) writeAtomic (fullfile (folder, name), text);
%! put ('in.mine', ["variable mu index 0.3 0.4 # first counts\n", ...
%!                  "variable seed index 10007\nvariable name index abc\n", ...
%!                  "# not.this\nfix a all mesh/surface file meshes/a.stl ", ...
%!                  "\ninclude more.inc\nprint \"${mu} ${seed} ${depth}\" ", ...
%!                  "file out\nprint \"RUN COMPLETE\"\n"]);
%! put ('more.inc', ["variable r index 1e-3\nread_data grains.data\n", ...
%!                   "variable r index 2\nprint ${r}\n"]);
%! cellfun (@(name) put (name, 'x'), ...
%!          {'meshes/a.stl', 'grains.data', 'not.this'});
%! given = struct ('model', 'Mine', 'script', fullfile (folder, 'in.mine'), ...
%!                 'output', 'out', 'seed', 'seed', ...
%!                 'vary', {{'mu=0.2:0.8'}}, 'set', {{'depth=0.1'}}, ...
%!                 'target', {{'run-out (m)=0.02', 'it''s=3'}});
%!test
%! target = fullfile (folder, 'DEMmodels', 'Mine');
%! [words, notes] = newScriptModel (root, target, given);
%! assert (isempty (notes));
%! d = headDefaults (fullfile (target, 'data.head'));
%! assert (d, struct ('mu', 0.5, 'r', 1e-3, 'depth', 0.1, 'runSeed', 10007));
%! assert ({resultInfo(target).name}, {'run-out (m)', 'it''s'});
%! assert (words.NAMES, '''run-out (m)'', ''it''''s''');
%! assert ({words.LOW, words.HIGH}, {'0.2', '0.8'});
%! text = fileread (fullfile (target, 'runscript'));
%! assert (~isempty (strfind (text, '"seed"')));
%! copied = {'in.mine', 'more.inc', 'grains.data', 'meshes/a.stl', 'not.this'};
%! assert (isfile (fullfile (target, copied)), logical ([1, 1, 1, 1, 0]));
%!test
%! % what would go wrong later is said at once
%! other = given;
%! other.seed = '';
%! other.set = {'depth=0.1', 'ghost=1'};
%! writeAtomic (given.script, ["variable mu equal 0.3\n", ...
%!                             "print \"${mu} ${depth}\" file out\n"]);
%! [~, notes] = newScriptModel (root, fullfile (folder, 'Other'), other);
%! marks = {'${runSeed}', 'RUN COMPLETE', '${ghost}', 'mu itself'};
%! assert (numel (notes), 4);
%! for k = 1:4
%!   assert (any (~cellfun (@isempty, strfind (notes, marks{k}))), marks{k});
%! end
%!test
%! wrong = {'newScriptModel:missingField', 'vary', {}; ...
%!          'newScriptModel:badValue', 'vary', {'mu=0.2'}; ...
%!          'newScriptModel:badValue', 'set', {'0.2'}; ...
%!          'newScriptModel:badValue', 'set', {'mu=x'}; ...
%!          'newScriptModel:badValue', 'set', {'density=2,6'}; ...
%!          'newScriptModel:badValue', 'set', {'density=2i'}; ...
%!          'newScriptModel:badValue', 'vary', {'mu=0,2:0,8'}; ...
%!          'newScriptModel:badValue', 'target', {'a=1,5'}; ...
%!          'scriptFiles:missingFile', 'script', '/nowhere/in.x'};
%! none = fullfile (folder, 'None');
%! for row = wrong'
%!   caught = '';
%!   try
%!     newScriptModel (root, none, setfield (given, row{2:3}));
%!   catch err
%!     caught = err.identifier;
%!   end
%!   assert (caught, ['DEcalioc:', row{1}]);
%! end
%! assert (~isfolder (none));
