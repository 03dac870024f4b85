% CHECKFINDMODELS  Looks up what the checks need to know of each model.
%
% CALL: MODELS = checkFindModels (INPUT, FOLDER, ROOT, MODE)
%
%   INPUT   scalar struct, the Input of loadInput
%   FOLDER  case folder (text)
%   ROOT    folder of the toolbox (text)
%   MODE    see checkCase; with 'noPrograms' getResults is not called
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

function models = checkFindModels (Input, folder, root, mode)
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
      models(k).folder = findModel (names{k}, folder, root);
    end
    if isempty (models(k).folder)
      continue
    end
    models(k).head = checkHead (models(k).folder);
    if ~strcmp (mode, 'noPrograms') && ...
       isfile (fullfile (models(k).folder, 'OctaveFuns', 'getResults.m'))
      models(k) = dryRun (models(k), strcmp (mode, 'full'));
    end
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
% which a crash or a loop in it does not carry away (limit 20 s). COUNT NaN
% where it gives no answer. What lies on the path here, does so there.
function model = dryRun (model, isFull)
  work = privateFolder ();
  tidy = onCleanup (@() system (['rm -rf ', shellQuote(work)]));
  octave = fullfile (OCTAVE_EXEC_HOME (), 'bin', 'octave-cli');
  if ~isfile (octave)
    octave = 'octave-cli';
  end
  command = sprintf (['cd %s && OCTAVE_HISTFILE=/dev/null ' ...
                      'DECALIOC_DRY_MODEL=%s DECALIOC_DRY_NAME=%s ' ...
                      'DECALIOC_DRY_FRESH=%d ' ...
                      'timeout -k 2 20 %s --norc --quiet --no-gui ' ...
                      '--path %s --eval checkDryRunWorker ' ...
                      '> /dev/null 2>&1 < /dev/null'], shellQuote (work), ...
                     shellQuote (make_absolute_filename (model.folder)), ...
                     shellQuote (model.name), isFull, shellQuote (octave), ...
                     shellQuote (path ()));
  [~, ~] = system (command);
  lines = strsplit (checkReadText (fullfile (work, 'answer')), "\n", ...
                    'CollapseDelimiters', false);
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
