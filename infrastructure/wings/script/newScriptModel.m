% NEWSCRIPTMODEL  Makes a model of a LIGGGHTS script that takes -var NAME VALUE.
%
% CALL: [WORDS, NOTES] = newScriptModel (ROOT, TARGET, GIVEN)
%
%   ROOT    folder of the toolbox (text)
%   TARGET  model folder to be made (text)
%   GIVEN   scalar struct: model (name), script (path), output (file with the
%           results, '': output_results), seed ('': runSeed), mean (share of its
%           rows, see readResults; '': 0), post (path of a program that writes
%           or prints the output, '': none), and cells of texts vary
%           (NAME=LOW:HIGH), set and target (NAME=NUMBER, target with :UNIT),
%           curve (PLACE:NAME=FILE, see scriptCurves)
%   WORDS   scalar struct of texts for templates/scriptCase, with a curve for
%           templates/scriptCurveCase
%   NOTES   cell of sentences for the user
%
% Errors: DEcalioc:newScriptModel:missingField (a parameter or a target),
% :badValue, :cannotWrite; DEcalioc:scriptFiles:missingFile; those of
% fillTemplate

function [words, notes] = newScriptModel (root, target, given)
  [names, limits] = namedNumbers (given.vary, '--vary', 2);
  [fixed, values] = namedNumbers (given.set, '--set', 1);
  [results, measured, units] = namedNumbers (given.target, '--target', 1);
  curves = scriptCurves (givenField (given, 'curve', {}));
  if isempty (names) || isempty (results) && isempty (curves)
    error ('DEcalioc:newScriptModel:missingField', ...
           ['--script needs at least one parameter and one measured value, ' ...
            'got %d and %d. For example: --vary mu=0.2:0.8 --target ' ...
            'height=0.0057'], numel (names), numel (results));
  end
  checkTwice (names, limits, fixed, results, curves, given);
  seed = givenField (given, 'seed', 'runSeed');
  output = givenField (given, 'output', 'output_results');
  [~, base, ending] = fileparts (given.script);
  checkWords (results, seed, output, [base, ending]);
  share = shareOf (givenField (given, 'mean', '0'));
  found = scriptFiles (given.script);
  post = scriptPost (givenField (given, 'post', ''), found);
  found.files = setdiff ([found.files, post.files], ...
                         fullfile (fileparts (found.scripts{1}), output));
  tree = scriptTree (found, fileparts (found.scripts{1}), ...
                     [readdir(fullfile (root, 'templates', 'script'))', ...
                      {'data.head', 'results.csv'}]);
  at = find (ismember (tree.from, found.scripts));
  texts = cellfun (@withoutMark, tree.from(at), 'UniformOutput', false);
  [texts, all, edits] = editScripts (texts, [names, fixed], given.seed);
  checkNames (all, seed);
  chosen = [all; num2cell([mean(limits, 1), values])];
  variables = mergeFields (found.variables, struct (chosen{:}));
  % the seed of the packing has a name of its own in data.head
  variables = rmfield (variables, intersect (fieldnames (variables), seed));
  words = struct ('CURVES', curveWords (curves), 'MODEL', given.model, 'SCRIPT', ...
                  [base, ending], 'SEED', seed, ...
                  'OUTPUT', output, 'PLACE', placeText (found, tree), ...
                  'POST', postText (post, tree, output), ...
                  'RESULTS', [tree.place, repmat('/', 1, ~isempty (tree.place)), ...
                              output], 'SHARE', sprintf ('%.10g', share));
  tree.texts = cell (size (tree.from));
  tree.texts(at) = texts;
  makeFolder (root, target, words, tree, variables, ...
              resultLines ([results, {curves.name}], [units, {curves.unit}], ...
                           [cell(size (results)), arrayfun(@overText, curves, ...
                                                           'UniformOutput', false)]));
  words = caseWords (words, all(1:numel (names)), limits, results, measured);
  words.ROWS = measuredRows (given.model, results, measured, units, curves);
  trial = fullfile (fileparts (found.scripts{1}), output);
  notes = strcat ([edits, modelNotes(target), setdiff({curves.note}, {''}), ...
                   trialNote(trial, results, share)], '.');
end

% LIGGGHTS takes a mark of UTF-8 (BOM) for the begin of a word.
function text = withoutMark (file)
  text = fileread (file);
  if strncmp (text, char ([239, 187, 191]), 3)
    text = text(4:end);
  end
end

function share = shareOf (text)
  share = str2double (text);
  if ~(share >= 0 && share <= 1)
    error ('DEcalioc:newScriptModel:badValue', ...
           ['--mean must be a share of the rows between 0 and 1 (0.2: the ' ...
            'mean of the last fifth), got %s.'], text);
  end
end

% What a trial by hand has left shows whether its results will be found.
function note = trialNote (file, names, share)
  note = cell (1, 0);
  if isfile (file)
    values = readResults (file, names, share);
    parts = arrayfun (@(k) sprintf ('%s = %g', names{k}, values(k)), ...
                      1:numel (names), 'UniformOutput', false);
    how = {'the last row and line of a name count', ...
           sprintf('the mean of the last %g of its rows counts', share)};
    note = {['a trial has left ', file, ', which is read as: ', ...
             strjoin(parts, ', '), ' (', how{1 + (share > 0)}, ...
             repmat('; NaN: not found there', 1, any (isnan (values))), ')']};
  end
end

% Where LIGGGHTS is started, and the folders that it writes to.
function text = placeText (found, tree)
  text = '';
  if ~isempty (tree.place)
    text = sprintf ('cd -- ''%s'' || exit\n', tree.place);
  end
  start = fileparts (found.scripts{1});
  above = fileparts (start);
  folders = unique (cellfun (@fileparts, found.written, 'UniformOutput', false));
  isBelow = strncmp (folders, [start, '/'], numel (start) + 1);
  isBeside = strncmp (folders, [above, '/'], numel (above) + 1) & ~isBelow & ...
             ~strcmp (folders, start);
  names = [cellfun(@(f) f(numel (start) + 2:end), folders(isBelow), ...
                   'UniformOutput', false), ...
           cellfun(@(f) ['..', f(numel (above) + 1:end)], folders(isBeside), ...
                   'UniformOutput', false)];
  if ~isempty (names)
    names = cellfun (@shellQuote, names, 'UniformOutput', false);
    text = sprintf ('%smkdir -p -- %s\n', text, strjoin (names, ' '));
  end
end

% The call of a program that makes the results, from where LIGGGHTS was started; what
% it prints is the output, where it writes no such file.
function text = postText (post, tree, output)
  text = '';
  if ~isempty (post.file)
    isIt = strcmp (tree.from, post.file);
    place = tree.to{isIt};
    up = '';
    if strncmp (place, [tree.place, '/'], numel (tree.place) + 1)
      place = place(numel (tree.place) + 2:end);
    elseif ~isempty (tree.place)
      up = repmat ('../', 1, 1 + sum (tree.place == '/'));
    end
    text = sprintf ([' || exit\nset -o pipefail\n%s %s | tee printed.txt || exit\n', ...
                     '[ -e ''%s'' ] || cp printed.txt ''%s'''], post.program, ...
                    shellQuote ([up, place]), output, output);
  end
end

function text = resultLines (names, units, texts)
  lines = [names; units; texts];
  text = ["name,kind,unit,series,at,text\n", sprintf("%s,,%s,,,%s\n", lines{:})];
end

% 'force over time in ms': no column of results.csv holds the unit of the places.
function text = overText (curve)
  text = '';
  if ~isempty (curve.atUnit)
    text = sprintf ('%s over %s in %s', curve.name, curve.place, curve.atUnit);
  end
end

% What is said twice would be lost once.
function checkTwice (names, limits, fixed, results, curves, given)
  seed = {givenField(given, 'seed', '')};
  lists = {'--vary, --set and --seed', [names, fixed, seed]; ...
           '--target and --curve', [results, {curves.name}]};
  for list = lists'
    [~, first] = unique (list{2}, 'first');
    twice = list{2}(setdiff (1:numel (list{2}), first));
    if ~isempty (twice)
      error ('DEcalioc:newScriptModel:badValue', ...
             '%s must name different things, got %s twice. Take one of the two out.', ...
             list{1}, twice{1});
    end
  end
  k = find (limits(1, :) >= limits(2, :), 1);
  if ~isempty (k)
    error ('DEcalioc:newScriptModel:badValue', ...
           '--vary must give the lower limit first, got %s=%g:%g.', names{k}, limits(:, k));
  end
end

% These become text of programs: bash, awk, Octave.
function checkWords (results, seed, output, script)
  isPath = @(w) ~isempty (regexp (w, '^(?!-)[^''"\\\n@$/]+(/[^''"\\\n@$/]+)*$', ...
                                  'once')) && isempty (strfind (w, '..'));
  path = 'a plain path below the run, without quotes, $ and @';
  rules = {'--target', results, @(w) ~any (w < 32 | ismember (w, '",;')), ...
           'one line of text without quotes, commas and semicolons'; ...
           '--output', {output}, isPath, path; ...
           '--script', {script}, isPath, path};
  refuseBad (rules);
  checkNames ({}, seed);
end

function checkNames (variables, seed)
  isName = @(w) ~isempty (regexp (w, '^[A-Za-z_]\w*$', 'once'));
  name = 'a variable of the script (letters, digits, _)';
  refuseBad ({'--vary and --set', variables, isName, name; ...
              '--seed', {seed}, isName, name});
end

function refuseBad (rules)
  for rule = rules'
    bad = rule{2}(~cellfun (rule{3}, rule{2}));
    if ~isempty (bad)
      error ('DEcalioc:newScriptModel:badValue', ...
             '%s must name %s, got %s.', rule{1}, rule{4}, bad{1});
    end
  end
end

% Of texts NAME=NUMBER, which a target may have a unit behind (2.5:N), or
% NAME=LOW:HIGH for COUNT 2; COUNT x n numbers.
function [names, numbers, units] = namedNumbers (texts, option, count)
  [names, units] = deal (cell (1, numel (texts)));
  units(:) = {''};
  numbers = zeros (count, numel (texts));
  for k = 1:numel (texts)
    equals = find (texts{k} == '=', 1, 'last');
    words = strsplit (texts{k}(equals + 1:end), ':');
    if strcmp (option, '--target') && numel (words) == 2
      units{k} = words{2};
      words(2) = [];
    end
    values = str2double (words);
    % str2double takes a comma for a separator of thousands: 0,2 would be 2
    if isempty (equals) || equals < 2 || numel (values) ~= count || ...
        ~all (isfinite (values)) || ~isreal (values) || ...
        any ([words{:}, units{k}] == ',')
      error ('DEcalioc:newScriptModel:badValue', ...
             ['%s must be given as %s, got %s. Write numbers with a ' ...
              'decimal point, without commas; the unit of a target stands ' ...
              'behind a colon (force=2.5:N).'], option, ...
             {'NAME=0.3', 'NAME=0.2:0.8'}{count}, texts{k});
    end
    names{k} = strtrim (texts{k}(1:equals - 1));
    numbers(:, k) = values;
  end
end

function text = curveWords (curves)
  rows_ = arrayfun (@(c) sprintf ('''%s'', ''%s''', c.place, c.name), curves, ...
                    'UniformOutput', false);
  text = strjoin (rows_, '; ');
end

% Lines of measured.csv: single results, then the points of the curves.
function text = measuredRows (model, results, measured, units, curves)
  rows_ = [repmat({model}, 1, numel (results)); results; num2cell(measured); units];
  text = sprintf ('%s,%s,,,%.10g,,%s,,\n', rows_{:});
  for c = curves
    for point = c.points'
      sd = '';
      if numel (point) > 2 && ~isnan (point(3))
        sd = sprintf ('%.10g', point(3));
      end
      text = [text, sprintf('%s,,%s,%.10g,%.10g,%s,%s,,\n', model, c.name, ...
                            point(1:2), sd, c.unit)];
    end
  end
  text = strtrim (text);
end

% In a draft beside it, so that the model is there whole or not at all.
function makeFolder (root, target, words, tree, variables, results)
  place = privateFolder ();
  tidy = onCleanup (@() system (['rm -rf ', shellQuote(place)]));
  source = fullfile (place, 'source');
  fillTemplate (fullfile (root, 'templates', 'script'), source, words);
  if ~isempty (words.CURVES)
    own = fullfile (place, 'own');
    fillTemplate (fullfile (root, 'templates', 'scriptCurve'), own, ...
                  setfield (words, 'FORM', 'm'));
    name = fullfile ('OctaveFuns', 'getResults.m');
    writeAtomic (fullfile (source, name), fileread (fullfile (own, name)));
  end
  for k = 1:numel (tree.from)
    copy = fullfile (source, tree.to{k});
    [~, ~] = mkdir (fileparts (copy));
    [status, why] = system (['cp -L -- ', shellQuote(tree.from{k}), ' ', ...
                             shellQuote(copy), ' 2>&1']);
    if status ~= 0
      error ('DEcalioc:newScriptModel:cannotWrite', ...
             '%s, which the script names, must be copied, got: %s', ...
             tree.from{k}, strtrim (why));
    end
    if ~isempty (tree.texts{k})
      writeAtomic (copy, tree.texts{k});
    end
  end
  writeAtomic (fullfile (source, 'data.head'), ...
               ["# Variables of the script, SI units. A run appends its ", ...
                "own values: the\n# last line that names a variable ", ...
                "counts.\n", headLines(variables), ...
                "variable runSeed equal 10007    # a prime above 10,000\n"]);
  writeAtomic (fullfile (source, 'results.csv'), results);
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

%!shared folder, given, root
%! root = fileparts (fileparts (which ('startToolbox')));
%! folder = tempname ();
%! mkdir (fullfile (folder, 'meshes'));
%! put = @(name, text) writeAtomic (fullfile (folder, name), text);
%! put ('in.mine', ["variable mu index 0.3 0.4 # first counts\n", ...
%!                  "variable seed index 10007\nvariable name index abc\n", ...
%!                  "# not.this\nfix a all mesh/surface file meshes/a.stl ", ...
%!                  "\ninclude more.inc\nprint \"${mu} ${seed} ${depth}\" ", ...
%!                  "file out\nrun 1\nprint \"RUN COMPLETE\"\n"]);
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
%! marks = {'${runSeed}', 'RUN COMPLETE', '${ghost}', 'mu has the style index'};
%! marks{end + 1} = 'no command run';
%! assert (numel (notes), 5);
%! for k = 1:5
%!   assert (any (~cellfun (@isempty, strfind (notes, marks{k}))), marks{k});
%! end
%!test
%! % nothing is lost by being said twice; limits rise; names fit a table
%! odd = {'vary', {'mu=0.2:0.8', 'mu=0.3:0.9'}, 'mu twice'; 'set', {'mu=0.3'}, 'mu twice'; ...
%!        'seed', 'mu', 'mu twice'; 'target', {'h=1', 'h=2'}, 'h twice'; ...
%!        'vary', {'mu=0.8:0.2'}, 'the lower limit first'; ...
%!        'target', {'h, total=1'}, 'commas'};
%! for row = odd'
%!   said = '';
%!   try
%!     newScriptModel (root, fullfile (folder, 'Odd'), setfield (given, row{1:2}));
%!   catch err
%!     said = err.message;
%!   end
%!   assert (! isempty (strfind (said, row{3})), said);
%! end
%! % a mark of UTF-8 is no word of LIGGGHTS
%! marked = fullfile (folder, 'in.marked');
%! writeAtomic (marked, [char([239, 187, 191]), fileread(given.script)]);
%! target = fullfile (folder, 'Marked');
%! newScriptModel (root, target, setfield (given, 'script', marked));
%! assert (strncmp (fileread (fullfile (target, 'in.marked')), 'variable mu', 11));
%!test
%! % results that a trial has left show how they will be read
%! other = given;
%! other.target = {'force=2.5:N'};
%! forms = {"t,force [N]\n0,1\n1,3\n", "force 1\nother 2\nforce 3\n", ...
%!          "# Fix print output for fix p\n0 1\n1 3\n", ...
%!          "# Time-averaged data for fix v\n# TimeStep v_force\n1 1\n9 3\n", ...
%!          "Step Atoms force\n0 5 1\n10 5 3\nLoop time of 2\n"};
%! for k = 1:numel (forms)
%!   writeAtomic (fullfile (folder, 'out'), forms{k});
%!   target = fullfile (folder, sprintf ('Form%d', k));
%!   [~, notes] = newScriptModel (root, target, other);
%!   assert (any (~cellfun (@isempty, strfind (notes, 'force = 3 ('))), forms{k});
%!   assert (resultInfo (target).unit, 'N');
%! end
%! other.mean = '1';
%! [~, notes] = newScriptModel (root, fullfile (folder, 'Mean'), other);
%! assert (any (~cellfun (@isempty, strfind (notes, 'force = 2 ('))));
%!test
%! wrong = {'newScriptModel:missingField', 'vary', {}; ...
%!          'newScriptModel:badValue', 'vary', {'mu=0.2'}; ...
%!          'newScriptModel:badValue', 'set', {'0.2'}; ...
%!          'newScriptModel:badValue', 'set', {'mu=x'}; ...
%!          'newScriptModel:badValue', 'set', {'density=2,6'}; ...
%!          'newScriptModel:badValue', 'set', {'density=2i'}; ...
%!          'newScriptModel:badValue', 'vary', {'mu=0,2:0,8'}; ...
%!          'newScriptModel:badValue', 'target', {'a=1,5'}; ...
%!          'newScriptModel:badValue', 'target', {'a=1:N:m'}; ...
%!          'newScriptModel:badValue', 'mean', '2'; ...
%!          'scriptProperty:unknownName', 'vary', {'friction 1-2=0:1'}; ...
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

% SPDX-License-Identifier: GPL-3.0-only
