% NEWSCRIPTMODEL  Makes a model of a LIGGGHTS script that takes -var NAME VALUE.
%
% CALL: [WORDS, NOTES] = newScriptModel (ROOT, TARGET, GIVEN)
%
%   ROOT    folder of the toolbox (text)
%   TARGET  model folder to be made (text)
%   GIVEN   scalar struct: model (name), script (path), output (name of the file
%           with the results, '': output_results), seed ('': runSeed), and cells
%           of texts vary (NAME=LOW:HIGH), set and target (NAME=NUMBER)
%   WORDS   scalar struct of texts for templates/scriptCase
%   NOTES   cell of sentences for the user
%
% Errors: DEcalioc:newScriptModel:missingField, without a parameter or a target;
% DEcalioc:newScriptModel:badValue, a name that cannot stand in a program;
% DEcalioc:newScriptModel:cannotWrite; those of scriptFiles and fillTemplate

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
  seed = orElse (given.seed, 'runSeed');
  output = orElse (given.output, 'output_results');
  checkWords ([names, fixed], seed, results, output, [base, ending]);
  [files, variables, text] = scriptFiles (given.script);
  for k = 1:numel (names)
    variables.(names{k}) = mean (limits(:, k));
  end
  for k = 1:numel (fixed)
    variables.(fixed{k}) = values(k);
  end
  words = struct ('MODEL', given.model, 'SCRIPT', [base, ending], ...
                  'SEED', seed, 'OUTPUT', output);
  % the seed of the packing has a name of its own in data.head
  variables = dropField (variables, seed);
  makeFolder (root, target, given, words, files, variables, results);
  words = caseWords (words, names, limits, results, measured);
  notes = notesOn (text, words, variables);
end

% These become text of programs: bash, awk, Octave.
function checkWords (variables, seed, results, output, script)
  isName = @(w) ~isempty (regexp (w, '^[A-Za-z_]\w*$', 'once'));
  isPath = @(w) ~isempty (regexp (w, '^[\w.+-]+(/[\w.+-]+)*$', 'once')) && ...
                w(1) ~= '-' && isempty (strfind (w, '..'));
  isLine = @(w) ~any (w < 32);
  wanted = {'a variable of the script (letters, digits, _)', ...
            'a plain path below the run (letters, digits, _ - + . /)', ...
            'one line of text'};
  given = [repmat({'--vary and --set'; isName; 1}, 1, numel (variables)), ...
           repmat({'--target'; isLine; 3}, 1, numel (results)), ...
           {'--seed'; isName; 1}, {'--output'; isPath; 2}, ...
           {'--script'; isPath; 2}];
  given(4, :) = [variables, results, {seed, output, script}];
  for word = given
    if ~word{2}(word{4})
      error ('DEcalioc:newScriptModel:badValue', ...
             '%s must name %s, got %s.', word{1}, wanted{word{3}}, word{4});
    end
  end
end

% Of texts NAME=NUMBER or, for COUNT 2, NAME=LOW:HIGH: 1 x n names, COUNT x n
% numbers.
function [names, numbers] = namedNumbers (texts, option, count)
  names = cell (1, numel (texts));
  numbers = zeros (count, numel (texts));
  examples = {'NAME=0.3', 'NAME=0.2:0.8'};
  for k = 1:numel (texts)
    equals = find (texts{k} == '=', 1, 'last');
    words = strsplit (texts{k}(equals + 1:end), ':');
    values = str2double (words);
    if isempty (equals) || equals < 2 || numel (values) ~= count || ...
        ~all (isfinite (values))
      error ('DEcalioc:newScriptModel:badValue', ...
             '%s must be given as %s, got %s.', option, ...
             examples{count}, texts{k});
    end
    names{k} = texts{k}(1:equals - 1);
    numbers(:, k) = values;
  end
end

function text = orElse (text, default)
  if isempty (text)
    text = default;
  end
end

function s = dropField (s, name)
  if isfield (s, name)
    s = rmfield (s, name);
  end
end

% In a draft beside it, so that the model is there whole or not at all.
function makeFolder (root, target, given, words, files, variables, results)
  source = tempname ();
  tidy = onCleanup (@() system (['rm -rf ', shellQuote(source)]));
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
  lines = {["# Variables of the script, SI units. A run appends its own ", ...
            "values: the\n# last line that names a variable counts.\n"]};
  for name = fieldnames (variables)'
    lines{end + 1} = sprintf ("variable %s equal %.17g\n", name{1}, ...
                              variables.(name{1}));
  end
  lines{end + 1} = "variable runSeed equal 10007    # a prime above 10,000\n";
  writeAtomic (fullfile (source, 'data.head'), [lines{:}]);
  table = sprintf ('%s,length,,,,\n', results{:});
  writeAtomic (fullfile (source, 'results.csv'), ...
               ["name,kind,unit,series,at,text\n", table]);
  fillTemplate (source, target, struct ());
end

function words = caseWords (words, names, limits, results, measured)
  list = @(format, values) strjoin (arrayfun (@(v) sprintf (format, v), ...
                                              values, 'UniformOutput', ...
                                              false), ', ');
  quoted = @(texts) ['''', strjoin(strrep (texts, '''', ''''''), ...
                                   ''', '''), ''''];
  words.SAMPLES = sprintf ('%d', 2 * numel (names) + 6);
  words.NAMES = quoted (results);
  words.VALUES = list ('%.10g', measured);
  words.TOLS = list ('%g', 0.05 * ones (size (measured)));
  words.ASSIGN = quoted (names);
  words.LOW = list ('%.10g', limits(1, :));
  words.HIGH = list ('%.10g', limits(2, :));
  words.FORM = 'm';
end

function notes = notesOn (text, words, variables)
  notes = {};
  isUsed = @(name) ~isempty (regexp (text, ['(\$\{|v_)', name, '\>'], 'once'));
  if ~isUsed (words.SEED)
    notes{end + 1} = sprintf (['the script does not use ${%s}: all its ' ...
                               'packings will be the same one. Put it ' ...
                               'there as the seed of fix insert, or name ' ...
                               'its variable with --seed.'], words.SEED);
  end
  if isempty (strfind (text, 'RUN COMPLETE'))
    notes{end + 1} = ['the script does not end with print "RUN ' ...
                      'COMPLETE": a run that breaks off may then be taken ' ...
                      'for a whole one.'];
  end
  for name = fieldnames (variables)'
    if ~isUsed (name{1})
      notes{end + 1} = sprintf (['the script does not use ${%s}: it will ' ...
                                 'change nothing.'], name{1});
    end
    again = ['^[ \t]*variable[ \t]+', name{1}, '[ \t]+equal'];
    if ~isempty (regexp (text, again, 'once', 'lineanchors'))
      notes{end + 1} = sprintf (['the script sets %s itself, as a ' ...
                                 'variable of style equal: LIGGGHTS will ' ...
                                 'stop. Write index for equal there.'], ...
                                name{1});
    end
  end
end

%!shared folder, given, root
%! root = fileparts (fileparts (which ('startToolbox')));
%! folder = tempname ();
%! mkdir (folder);
%! writeAtomic (fullfile (folder, 'in.mine'), ...
%!              ["variable mu index 0.3\nvariable seed index 10007\n", ...
%!               "print \"${mu} ${seed} ${depth}\" file out\n", ...
%!               "print \"RUN COMPLETE\"\n"]);
%! given = struct ('model', 'Mine', 'script', fullfile (folder, 'in.mine'), ...
%!                 'output', 'out', 'seed', 'seed', ...
%!                 'vary', {{'mu=0.2:0.8'}}, 'set', {{'depth=0.1'}}, ...
%!                 'target', {{'run-out (m)=0.02', 'it''s=3'}});
%!test
%! target = fullfile (folder, 'DEMmodels', 'Mine');
%! [words, notes] = newScriptModel (root, target, given);
%! assert (notes, {});
%! d = headDefaults (fullfile (target, 'data.head'));
%! assert (d, struct ('mu', 0.5, 'depth', 0.1, 'runSeed', 10007));
%! assert ({resultInfo(target).name}, {'run-out (m)', 'it''s'});
%! assert (words.NAMES, '''run-out (m)'', ''it''''s''');
%! assert ({words.LOW, words.HIGH}, {'0.2', '0.8'});
%! text = fileread (fullfile (target, 'runscript'));
%! assert (~isempty (strfind (text, '"seed"')));
%!test
%! % what would go wrong later is said at once
%! other = given;
%! other.seed = '';
%! other.set = {'depth=0.1', 'ghost=1'};
%! writeAtomic (given.script, ["variable mu equal 0.3\n", ...
%!                             "print \"${mu} ${depth}\" file out\n"]);
%! [~, notes] = newScriptModel (root, fullfile (folder, 'Other'), other);
%! marks = {'${runSeed}', 'RUN COMPLETE', 'mu itself', '${ghost}'};
%! assert (numel (notes), 4);
%! for k = 1:4
%!   assert (any (~cellfun (@isempty, strfind (notes, marks{k}))), marks{k});
%! end
%!test
%! bad = {'vary', {}, 'missingField'; 'vary', {'mu=0.2'}, 'badValue'; ...
%!        'set', {'0.2'}, 'badValue'; 'set', {'mu=x'}, 'badValue'};
%! for row = bad'
%!   caught = '';
%!   try
%!     newScriptModel (root, fullfile (folder, 'None'), ...
%!                     setfield (given, row{1}, row{2}));
%!   catch err
%!     caught = err.identifier;
%!   end
%!   assert (caught, ['DEcalioc:newScriptModel:', row{3}]);
%! end
%! assert (~isfolder (fullfile (folder, 'None')));
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (folder, 's');
