% CHECKFINDMODELS  Looks up what the checks need to know of each model.
%
% CALL: MODELS = checkFindModels (INPUT, FOLDER, ROOT, MODE [, VARIABLES])
%
%   INPUT   scalar struct, the Input of loadInput
%   FOLDER  case folder (text)
%   ROOT    folder of the toolbox (text)
%   MODE    see checkCase; with 'noPrograms' getResults is not called
%   VARIABLES  cell of the names of the parameters, see findModel
%   MODELS  1 x M struct array: name; folder ('' where there is none, or the
%           name is not usable); head (see checkHead); cpu (NaN where not
%           usable); count (number of results, NaN where not known); message
%           (why getResults cannot be used, or ''); fields (names of the results
%           where it returns a struct); left (k x 3 cell of texts: index, value
%           and file of results without a run, see leftoverResults; looked for
%           with 'full' alone)
%
% getResults reads the files of the model's sample/, if it has one. Where that
% throws, an empty run folder is tried: published files then return NaN for each
% result.

function models = checkFindModels (Input, folder, root, mode, variables)
  if nargin < 5
    variables = {};
  end
  names = modelNames (Input);
  models = struct ('name', names, 'folder', '', 'head', [], 'cpu', NaN, ...
                   'count', NaN, 'message', '', 'fields', {{}}, ...
                   'left', {cell(0, 3)});
  cpu = givenField (Input, 'cpu', []);
  for k = 1:numel (models)
    if isKind ('vector', cpu) && numel (cpu) >= k
      models(k).cpu = double (cpu(k));
    end
    if ~isempty (names{k})
      models(k).folder = findModel (names{k}, folder, root, variables);
    end
    if isempty (models(k).folder)
      continue
    end
    models(k).head = checkHead (models(k).folder);
  end
  if ~strcmp (mode, 'noPrograms')
    models = dryRuns (models, strcmp (mode, 'full'));
  end
end

% '' for a name that is not usable.
function names = modelNames (Input)
  names = cell (1, 0);
  if isfield (Input, 'model') && ischar (Input.model)
    names = {Input.model};
  elseif isfield (Input, 'model') && iscell (Input.model) && ...
         isvector (Input.model)
    names = Input.model(:)';
  end
  names(~cellfun (@(n) isKind ('folder', n), names)) = {''};
end

% Counts the results without a run: getResults is called by another Octave,
% which a crash or a loop in it does not carry away. One Octave asks all models,
% as its start takes most of the time; where it ends before the last one, the
% first without an end of its answer has no more, and the others are asked again.
function models = dryRuns (models, isFull)
  isAsked = @(model) isfile (fullfile (model.folder, 'OctaveFuns', ...
                                       'getResults.m'));
  asked = find (arrayfun (isAsked, models));
  while ~isempty (asked)
    answers = askModels (models(asked), isFull);
    hasEnd = ~cellfun (@isempty, regexp (answers, '^end$', 'lineanchors'));
    n = find ([~hasEnd, true], 1);
    for i = 1:min (n, numel (asked))
      models(asked(i)) = withAnswer (models(asked(i)), answers{i});
    end
    asked = asked(n + 1:end);
  end
end

% ANSWERS: 1 x n cell of texts, see checkDryRunWorker; limit 20 s a model. What lies
% on the path here, does so there.
function answers = askModels (models, isFull)
  work = privateFolder ();
  tidy = onCleanup (@() system (['rm -rf ', shellQuote(work)]));
  octave = fullfile (OCTAVE_EXEC_HOME (), 'bin', 'octave-cli');
  if ~isfile (octave)
    octave = 'octave-cli';
  end
  names = '';
  for k = 1:numel (models)
    names = [names, sprintf(' DECALIOC_DRY_MODEL%d=%s DECALIOC_DRY_NAME%d=%s', k, ...
                            shellQuote (make_absolute_filename (models(k).folder)), ...
                            k, shellQuote (models(k).name))];
  end
  command = sprintf (['cd %s && OCTAVE_HISTFILE=/dev/null%s ' ...
                      'DECALIOC_DRY_FRESH=%d ' ...
                      'timeout -k 2 %d %s --norc --quiet --no-gui ' ...
                      '--path %s --eval checkDryRunWorker ' ...
                      '> /dev/null 2>&1 < /dev/null'], shellQuote (work), names, ...
                     isFull, 20 * numel (models), shellQuote (octave), ...
                     shellQuote (path ()));
  [~, ~] = system (command);
  for k = numel (models):-1:1
    answers{k} = checkReadText (fullfile (work, sprintf ('answer%d', k)));
  end
end

function model = withAnswer (model, answer)
  lines = strsplit (answer, "\n", 'CollapseDelimiters', false);
  lines(end + 1:3) = {''};
  model.count = str2double (lines{1});
  if ~(model.count >= 1)
    model.count = NaN;
  end
  model.message = strtrim (lines{2});
  model.fields = regexp (lines{3}, '\S+', 'match');
  left = regexp (strjoin (lines(4:end), "\n"), '^(\d+) (\S+) (.*)$', ...
                 'tokens', 'lineanchors', 'dotexceptnewline');
  model.left = vertcat (cell (0, 3), left{:});
end

%!function m = tryModel (code)
%!  folder = tempname ();
%!  mkdir (fullfile (folder, 'DEMmodels', 'Toy', 'OctaveFuns'));
%!  writeAtomic (fullfile (folder, 'DEMmodels', 'Toy', 'OctaveFuns', ...
%!                         'getResults.m'), code);
%!  m = checkFindModels (struct ('model', 'Toy', 'cpu', 2), folder, folder, ...
%!                       'full');
%!endfunction
%!test
%! m = tryModel (["function res = getResults (model, folderName)\n", ...
%!   "global path\ntry\n  res{1} = csvread ([path, 'optim/', model, '/',", ...
%!   " folderName, '/out']);\ncatch\n  res{1} = NaN;\nend\n", ...
%!   "res{2} = NaN;\nend\n"]);
%! assert ({m.count, m.message, m.cpu}, {2, '', 2});
%!test
%! m = tryModel ('function res = getResults (a, b), res = {1, ; end');
%! assert (isnan (m.count) && ! isempty (strfind (m.message, 'parse error')));
%!test
%! m = tryModel (["function res = getResults (model, folderName)\n", ...
%!                "res = struct ('w', [NaN, NaN], 'mass', NaN);\nend\n"]);
%! assert ({m.count, m.message, m.fields}, {2, '', {'w', 'mass'}});
%!test
%! Input = struct ('model', {{'NoSuchModel', '../x', 3}}, 'cpu', [1, 2]);
%! m = checkFindModels (Input, '/nowhere', '/nowhere', 'full');
%! assert ({m.name}, {'NoSuchModel', '', ''});
%! assert ([m.cpu], [1, 2, NaN]);
%! assert (isnan ([m.count]), true (1, 3));
%!test
%! % one that ends its Octave, in the middle, has no answer; the others have
%! folder = tempname ();
%! code = {"res = {1};", "kill (getpid (), 9); res = {1, 2};", "res = {1, 2, 3};"};
%! for k = 1:3
%!   name = sprintf ('M%d', k);
%!   mkdir (fullfile (folder, 'DEMmodels', name, 'OctaveFuns'));
%!   writeAtomic (fullfile (folder, 'DEMmodels', name, 'OctaveFuns', ...
%!                          'getResults.m'), ...
%!                ["function res = getResults (a, b)\n", code{k}, "\nend\n"]);
%! end
%! m = checkFindModels (struct ('model', {{'M1', 'M2', 'M3'}}, 'cpu', 1), ...
%!                      folder, folder, 'reading');
%! assert ([m.count], [1, NaN, 3]);
%!assert (isempty (checkFindModels (struct (), '/nowhere', '/nowhere', 'full')))
%!test
%! % results without a run are looked for with 'full' alone
%! folder = tempname ();
%! model = fullfile (folder, 'DEMmodels', 'Toy');
%! mkdir (fullfile (model, 'OctaveFuns'));
%! writeAtomic (fullfile (model, 'OctaveFuns', 'getResults.m'), ...
%!   ["function res = getResults (model, name)\nglobal path\n", ...
%!    "res = {load([path, 'optim/', model, '/', name, '/out 1'])};\nend\n"]);
%! writeAtomic (fullfile (model, 'out 1'), '4.29');
%! find = @(mode) checkFindModels (struct ('model', 'Toy', 'cpu', 2), ...
%!                                 folder, folder, mode).left;
%! assert (find ('full'), {'1', '4.29', 'out 1'});
%! assert (find ('reading'), cell (0, 3));

% SPDX-License-Identifier: GPL-3.0-only
