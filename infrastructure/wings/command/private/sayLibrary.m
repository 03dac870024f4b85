% SAYLIBRARY  Lists the runs of a store, or takes runs of it out of use.
%
% CALL: STATUS = sayLibrary (ROOT, FOLDER, ARGS)          decalioc runs
%       STATUS = sayLibrary (ROOT, FOLDER, ARGS, true)    decalioc forget
%
%   ROOT    folder of the toolbox (text)
%   FOLDER  current folder (text)
%   ARGS    cell of texts: the store (default: DECALIOC_STORE, else FOLDER); to
%           forget also the model and numbers or ranges FIRST:LAST, or --case
%           with the case folder; --back takes them into use again
%   STATUS  0; 2 where the store holds no runs (decalioc runs)
%
% Errors: DEcalioc:sayLibrary:missingField, :badValue (a number), :missingFile
% (no such store or model), :unknownName (no run is one of those); those of
% forgetRuns

function status = sayLibrary (root, folder, args, toForget)
  if nargin > 3
    status = forget (args, folder);
    return
  end
  [~, words] = commandOptions (args, struct ());
  words = [words, {getenv('DECALIOC_STORE'), folder}];
  first = find (~cellfun (@isempty, words), 1);
  store = absoluteFrom (folder, words{first});
  names = readdir (fullfile (store, 'optim'));
  names = names(~strncmp (names, '.', 1));
  status = 2;
  for name = names'
    kinds = readLibrary (fullfile (store, 'optim', name{1}));
    status = 0;
    sayModel (name{1}, onceEach (kinds));
  end
  if status > 0
    printf ('%s holds no runs\n', store);
  end
end

% A run that answered several questions is in several kinds.
function kinds = onceEach (kinds)
  seen = zeros (0, 1);
  for k = 1:numel (kinds)
    runs = kinds(k).runs;
    kinds(k).runs = runs(~ismember (runs(:, 1), seen), :);
    seen = [seen; kinds(k).runs(:, 1)];
  end
  kinds = kinds(~cellfun (@isempty, {kinds.runs}));
end

function sayModel (name, kinds)
  runs = cellfun (@(r) r(:, 1:6), {kinds.runs}, 'UniformOutput', false);
  runs = vertcat (zeros (0, 6), runs{:});
  seconds = runs(isfinite (runs(:, 4)), 4);
  counts = arrayfun (@(s) sum (runs(:, 2) == s), [1, 2, 3, -1]);
  printf ('%-12s %s: %d ok, %d invalid, %d failed, %d forgotten; %.3g core-hours\n', ...
          name, countText (rows (runs), 'run'), counts, ...
          sum (seconds) / 3600);
  for input = unique ({kinds.input})
    sayRig (input{1}, kinds(strcmp ({kinds.input}, input{1})));
  end
end

% Runs of one model folder and build, with the variables that they set.
function sayRig (input, kinds)
  printf ('  rig %s: %s\n', input(1:8), ...
          countText (sum (cellfun (@rows, {kinds.runs})), 'run'));
  range = struct ();
  for kind = kinds
    names = strsplit (kind.names, ' ');
    for k = 1:numel (names)
      values = [kind.runs(:, 6 + k); givenField(range, names{k}, [])(:)];
      range.(names{k}) = [min(values), max(values)];
    end
  end
  for name = setdiff (fieldnames (range), {'runSeed', 'RLTS', 'SIMTS'})'
    printf ('    %-22s %s\n', name{1}, ...
            sprintf (' to %.6g', unique (range.(name{1})))(5:end));
  end
  for label = unique ({kinds.label})
    ofCase = kinds(strcmp ({kinds.label}, label{1}));
    printf ('    of %s: %d\n', label{1}, ...
            sum (cellfun (@rows, {ofCase.runs})));
  end
end

function status = forget (args, here)
  [options, words] = commandOptions (args, struct ('case', 'one', ...
                                                   'back', 'flag'));
  origin = options.('case');
  if numel (words) < 2 || (numel (words) == 2) == isempty (origin)
    error ('DEcalioc:sayLibrary:missingField', ...
           ['decalioc forget needs a store, a model, and numbers of runs ' ...
            '(7 12:20) or --case FOLDER; decalioc runs STORE lists them.']);
  end
  [store, model] = words{1:2};
  store = absoluteFrom (here, store);
  ranges = rangesOf (words(3:end));
  if ~isfolder (fullfile (store, 'optim', model))
    error ('DEcalioc:sayLibrary:missingFile', ...
           ['decalioc forget: the store %s must hold runs of the model %s, ' ...
            'got no folder %s. decalioc runs STORE lists the models.'], ...
           store, model, fullfile (store, 'optim', model));
  end
  which = ranges;
  if ~isempty (origin)
    which = {origin, absoluteFrom(here, origin)};
  end
  [changed, later] = forgetRuns (store, model, which, options.back);
  if isempty (changed)
    refuseNone (store, model, options.back);
  end
  words = {['out of use; --back takes them in again. A start that needs ' ...
            'them makes them with another packing'], 'in use again'};
  printf ('%s%s %s. Nothing was deleted.\n', ...
          countText (numel (changed), ['run of ', model], ['runs of ', model]), ...
          sayLater (later), verb (numel (changed) + numel (later), ...
                                  words{1 + options.back}));
  status = 0;
end

function text = verb (n, words)
  verbs = {'are', 'is'};
  text = [verbs{1 + (n == 1)}, ' ', words];
end

% ', 2 runs of Tap and 1 run of Shake that started from it are'
function text = sayLater (later)
  models = unique (cellfun (@fileparts, later, 'UniformOutput', false));
  count = @(m) countText (sum (strcmp (cellfun (@fileparts, later, 'UniformOutput', ...
                                                false), m)), ...
                          ['run of ', m], ['runs of ', m]);
  parts = cellfun (count, models, 'UniformOutput', false);
  text = repmat ([', and ', strjoin(parts, ', '), ' that started from there,'], ...
                 1, ~isempty (later));
end

function refuseNone (store, model, isBack)
  what = {'to take out of use', 'that was forgotten, to take in again'};
  error ('DEcalioc:sayLibrary:unknownName', ...
         ['decalioc forget: a finished run of %s %s must be named, got ' ...
          'none. decalioc runs %s lists the cases; the folders of %s have ' ...
          'the numbers of the runs.'], model, what{1 + isBack}, ...
         shellQuote (store), fullfile (store, 'optim', model));
end

% Of texts NUMBER or FIRST:LAST; n x 2, the first and the last number.
function ranges = rangesOf (words)
  ranges = zeros (numel (words), 2);
  for k = 1:numel (words)
    parts = regexp (words{k}, '^(\d+)(:\d+)?$', 'tokens', 'once');
    ends = str2double (strrep (parts, ':', ''));
    ends = ends(isfinite (ends));
    if isempty (ends) || ends(end) < ends(1)
      error ('DEcalioc:sayLibrary:badValue', ...
             ['decalioc forget: a run must be given as a number or as ' ...
              'FIRST:LAST, got %s. For example: 7 12:20'], words{k});
    end
    ranges(k, :) = ends([1, end]);
  end
end

%!test
%! Case = newCase (standInCase (tempname ()));
%! evaluateDEM ([1, 2; 3, 4; 5, 6], Case);
%! text = evalc ('status = sayLibrary ('''', Case.store, {});');
%! assert (status, 0);
%! assert (~isempty (strfind (text, 'First        3 runs: 3 ok')));
%! assert (~isempty (regexp (text, '    a +1 to 5\n')));
%! assert (~isempty (strfind (text, ['of ', Case.folder, ': 3'])));
%! jobs = newJobs (Case, [1, 2; 3, 4; 5, 6], [], 1, 'plan')(1:2:end);
%! before = findRuns (jobs, Case);
%! evalc ('sayLibrary ('''', '''', {Case.store, ''First'', ''2:9''}, true);');
%! status = cellfun (@(r) r.status, findRuns (jobs, Case), ...
%!                   'UniformOutput', false);
%! assert (status, {'ok', 'forgotten', 'forgotten'});
%! evalc (['sayLibrary ('''', '''', {Case.store, ''First'', ''--back'', ', ...
%!         '''--case'', Case.folder}, true);']);
%! assert (findRuns (jobs, Case), before);
%! assert (evalc ('status = sayLibrary ('''', tempname (), {});')(1), '/');
%! assert (status, 2);
%!error id=DEcalioc:sayLibrary:missingField sayLibrary ('', '', {'x'}, true)
%!error id=DEcalioc:sayLibrary:badValue
%! sayLibrary ('', '', {'/nowhere', 'M', 'x'}, true)
%!test
%! % what is no number of a run changes nothing, and is said
%! Case = newCase (standInCase (tempname ()));
%! evaluateDEM ([1, 2; 3, 4], Case);
%! store = Case.store;
%! before = readLibrary (fullfile (store, 'optim', 'First'));
%! bad = {'badValue', {store, 'First', '1-2'}; ...
%!        'badValue', {store, 'First', '1,2'}; ...
%!        'badValue', {store, 'First', '1.5'}; ...
%!        'badValue', {store, 'First', '2:1'}; ...
%!        'badValue', {store, 'First', '1', 'x'}; ...
%!        'badValue', {store, 'First', '1:'}; ...
%!        'missingFile', {'/nowhere', 'First', '1'}; ...
%!        'missingFile', {store, 'Frist', '1'}; ...
%!        'unknownName', {store, 'First', '3:9999999999999'}; ...
%!        'unknownName', {store, 'First', '--back', '1'}; ...
%!        'unknownName', {store, 'First', '--case', '/nowhere'}};
%! for row = bad'
%!   caught = '';
%!   try
%!     evalc ('sayLibrary ('''', '''', row{2}, true);');
%!   catch err
%!     caught = err.identifier;
%!   end
%!   assert (caught, ['DEcalioc:sayLibrary:', row{1}]);
%! end
%! assert (readLibrary (fullfile (store, 'optim', 'First')), before);
%! % a case may be named as the user sees it
%! here = cd (fileparts (Case.folder));
%! back = onCleanup (@() cd (here));
%! [~, name] = fileparts (Case.folder);
%! text = evalc (['sayLibrary ('''', '''', {store, ''First'', ''--case'', ', ...
%!                '[''./'', name, ''/'']}, true);']);
%! assert (strncmp (text, '2 runs of First are out of use', 30), text);

% SPDX-License-Identifier: GPL-3.0-only
