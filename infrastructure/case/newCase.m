% NEWCASE  Makes a case of what the user gave, with all defaults filled in.
%
% CALL: CASE = newCase (RAW)
%       CASE = newCase (RAW, 'reading')
%
%   RAW   struct with the fields Input, optim, modelVars, assign, paramLims
%         (as loadInput.m returns them), folder (case folder) and root (toolbox
%         folder), see readInput
%   CASE  scalar struct (d parameters, M models, v variables of effects):
%     root, folder, store  folders of the toolbox, of the case, of optim/
%     names         1 x d cell, the parameters
%     limits        2 x d; a third row, 0 or 1, where some count in logarithms
%                   (toUnit)
%     bySelf        1 x d logical: they do so because of their limits
%     allowed       see checkAllowed; []: all values
%     paramMean, paramSd  1 x d; NaN: not measured separately
%     perCondition  1 x d logical
%     modelVars     struct, fixed model variables
%     coarse        1 x v struct, the levels: variable, levels, models (numbers)
%     effects       1 x e struct, see describeEffect; [] until withEffects
%     effectVars    1 x v cell, their variables; those of the levels stand first,
%                   as in the columns E of the data
%     models        1 x M: name, cpu, timeout, cost as in loadInput; folder ('':
%                   none), nTargets (results of a run), readings (of
%                   measured.csv: 1 x n struct result, series, at; else []),
%                   seconds (1 x n, good runs of this start; negative: cut off),
%                   coarse, settings (of the bench, readSettings)
%     further       cell, names of the last models: measured next tests
%     targets       see newTargets
%     isCost        logical: nothing but one cost, of which the smallest counts. Its
%                   runs.csv is the history of an optimiser: what the cost was made of
%                   nobody knows, so nothing can be missed, confirmed or explained
%     thinned       points of dense curves that are not fitted, see thinCurves
%     conditions    cell, names of the conditions of measured.csv
%     sessions      see groupMeasured: given, names, ratio, df
%     options       the other fields of Input and optim, and sets (at a time
%                   after the plan)
%     notes         cell of texts, warnings for the user
%     scatterNotes  see readingNotes
%     hashes        see hashModels; only in the copy for a round of runs
%
% checkCase looks at RAW first. Its faults are raised together, as one
% error under the identifier of the first. A measured.csv in the case folder
% takes the place of the fields of optim that are given target by target. With
% 'reading' what only a run needs may be missing.

function Case = newCase (raw, varargin)
  [faults, found] = checkCase (raw, varargin{:});
  if ~isempty (faults)
    error (faults(1).id, '%s', listFaults (faults));
  end
  Input = raw.Input;
  Case.root = raw.root;
  Case.folder = raw.folder;
  % the shell and the batch system know neither ~ nor this folder
  store = tilde_expand (givenField (Input, 'store', raw.folder));
  Case.store = make_absolute_filename (store);
  Case.models = newModels (raw);
  Case.further = givenField (raw, 'further', {});
  Case.names = raw.assign(:)';
  Case.limits = found.box.limits;
  Case.allowed = found.box.allowed;
  Case.bySelf = found.box.bySelf;
  Case.paramMean = found.paramMean;
  Case.paramSd = found.paramSd;
  Case.modelVars = raw.modelVars;
  Case.coarse = newCoarse (givenField (Input, 'coarse', {}));
  [Case.models.coarse] = deal (Case.coarse);
  Case = plainCase (Case);
  Case.targets = newTargets (raw.optim, {Case.models.name}, found);
  Case.isCost = any (strcmp ({Case.targets.role}, 'smallest'));
  Case.thinned = givenField (found, 'thinned', []);
  Case.conditions = found.conditions;
  Case.sessions = found.sessions;
  Case.perCondition = ismember (Case.names, ...
                                givenField (raw.optim, 'perCondition', {}));
  Case.options = newOptions (Input, raw.optim);
  Case.notes = [caseNotes(raw, Case.models), unusedNotes(Case), densityNotes(Case)];
  note = storeNote (Case.store, Case.options.executor);
  Case.notes = [Case.notes, {note}(~isempty (note))];
  Case.scatterNotes = readingNotes (Case);
  for k = 1:numel (Case.models)
    ofModel = Case.targets([Case.targets.model] == k);
    Case.models(k).nTargets = numel (ofModel);
    if ~isempty (ofModel(1).result)
      Case.models(k).readings = struct ('result', {ofModel.result}, ...
                                        'series', {ofModel.series}, ...
                                        'at', {ofModel.at});
    end
  end
end

function text = listFaults (faults)
  lines = arrayfun (@(p) ['  - ', p.message], faults(:)', ...
                    'UniformOutput', false);
  text = sprintf ("%s in the input, nothing has been run:\n%s", ...
                  countText (numel (faults), 'problem', 'problems'), strjoin (lines, "\n"));
end

function models = newModels (raw)
  names = cellstr (raw.Input.model)(:)';
  n = numel (names);
  default = inputFields ('defaults');
  timeout = givenField (raw.Input, 'timeout', []);
  timeout(end + 1:n) = default.timeout;
  cost = double (givenField (raw.optim, 'cost', []));
  cost(end + 1:n) = default.cost;
  folders = cellfun (@(name) findModel (name, raw.folder, raw.root, raw.assign), ...
                     names, 'UniformOutput', false);
  models = struct ('name', names, 'folder', folders, ...
                   'cpu', num2cell (raw.Input.cpu(1:n)(:)'), ...
                   'timeout', num2cell (timeout(1:n)(:)'), 'nTargets', 0, ...
                   'seconds', [], 'cost', num2cell (cost(1:n)(:)'), ...
                   'readings', []);
  settings = cellfun (@readSettings, folders, 'UniformOutput', false);
  [models.settings] = settings{:};
end

function o = newOptions (Input, optim)
  given = struct ('Input', Input, 'optim', optim);
  for field = inputFields ()
    if field.isOption
      o.(field.name) = givenField (given.(field.part), field.name, field.default);
    end
  end
  for name = executorNames ()
    if isfield (Input, name{1})
      o.(name{1}) = Input.(name{1});
    end
  end
  if ~isempty (o.similar)
    o.similar = make_absolute_filename (tilde_expand (o.similar));
  end
  o.sets = describeExecutor (o.executor).sets (o);
end

% Levels as 1 x v struct, one element a variable: variable, levels (1 x L, the
% last one counts), models (numbers).
function coarse = newCoarse (given)
  coarse = struct ('variable', {}, 'levels', {}, 'models', {});
  for k = find (~cellfun (@isempty, given(:)'))
    level = given{k};
    number = find (strcmp ({coarse.variable}, level.variable));
    if isempty (number)
      number = numel (coarse) + 1;
      coarse(number) = struct ('variable', level.variable, 'levels', ...
                               toDigits (double (level.levels(:)')), ...
                               'models', []);
    end
    coarse(number).models(end + 1) = k;
  end
end

% What is no fault, but may be meant otherwise, in sentences for the user.
function notes = caseNotes (raw, models)
  [~, unread] = checkSettings (raw.Input, raw.optim);
  notes = strcat (unread, {[' in loadInput.m: DEcalioc does not use this ' ...
                            'field; your own files may']});
  for model = models
    if isfile (fullfile (model.folder, 'runscript')) && ...
       ~usesSeed (model.folder)
      notes{end + 1} = ['no file of DEMmodels/', model.name, ' uses ' ...
                        'runSeed: all runs of a set are one and the same ' ...
                        'packing, and tell nothing of its scatter. Take ' ...
                        'insertion seeds from ${runSeed} (docs/extend.md)'];
    end
  end
end

% data.head only declares it.
% The properties of the Rayleigh time are used here (assignParams).
function notes = unusedNotes (Case)
  notes = {};
  folders = {Case.models.folder};
  % of a case that only imports runs nobody sees what its program uses
  if ~all (cellfun (@(f) isfile (fullfile (f, 'runscript')), folders))
    return
  end
  [others, beyond] = cellfun (@(f) stagesOf (f, 'all'), folders, ...
                              'UniformOutput', false);
  [others, first] = unique ([{Case.models.name}, others{:}]);
  folders = [folders, beyond{:}];
  folders = folders(first);
  names = setdiff ([Case.names, fieldnames(Case.modelVars)', ...
                    {Case.coarse.variable}], ...
                   {'radiusP', 'densityP', 'youngsModulusP', ...
                    'poissonsRatioP', 'percentRayleigh'});
  places = cellfun (@(name) runPlace (Case, name, '0001'), others, ...
                    'UniformOutput', false);
  for name = unusedVariables (names, folders, places)
    notes{end + 1} = ['no file of the models uses the variable ', name{1}, ...
                      ': it changes nothing. Put ${', name{1}, '} where it ' ...
                      'belongs, or take it out of loadInput.m'];
  end
end

function yes = usesSeed (folder)
  yes = system (['grep -RIqw --exclude=data.head runSeed ', ...
                 shellQuote(folder), ' 2> /dev/null']) == 0;
  [~, stages] = stagesOf (folder);       % their packing is that of the model
  yes = yes || any (cellfun (@usesSeed, stages));
end

%!shared raw, level
%! raw = standInCase (tempname ());
%! level = struct ('variable', 'e', 'levels', [3; 2]);
%!function Case = with (raw, part, varargin)
%!  for k = 1:2:numel (varargin)
%!    raw.(part).(varargin{k}) = varargin{k + 1};
%!  end
%!  Case = newCase (raw);
%!endfunction
%!test
%! Case = newCase (raw);
%! assert (size (Case.limits), [2, 2]);
%! assert ([Case.targets.value], [400, 0.025, 3]);
%! assert ([Case.targets.model], [1, 1, 2]);
%! assert ([Case.targets.trials], [1, 1, 1]);
%! assert ([Case.models.nTargets], [2, 1]);
%! assert ([Case.models.cost], [1, 1]);
%! assert (Case.options.seed, 1);
%! assert (Case.paramSd, [NaN, NaN]);
%! assert ({Case.coarse, Case.effects}, {Case.coarse([]), []});
%!test
%! % trials: one number for a model, or one a target
%! Case = with (raw, 'optim', 'trials', {[], Inf});
%! assert ([Case.targets.trials], [1, 1, Inf]);
%! Case = with (raw, 'optim', 'trials', {5, 2}, ...
%!              'correlation', {[3, NaN], 'estimate'});
%! assert ([Case.targets.trials], [5, 5, 2]);
%! assert ([Case.targets.correlation], [3, 0, NaN]);
%!test
%! Case = with (raw, 'optim', 'cost', 4, 'paramSd', [NaN; 0.5], ...
%!              'paramMean', struct ('b', 2));
%! assert ([Case.models.cost], [4, 1]);
%! assert ([Case.paramMean; Case.paramSd], [NaN, 2; NaN, 0.5]);
%!assert (with (raw, 'Input', 'coarse', {level, level}).coarse, ...
%!        struct ('variable', 'e', 'levels', [3, 2], 'models', [1, 2]))
%!test
%! % the published file returns the values of all models as one column
%! Case = with (raw, 'optim', 'targetVal', [400; 0.025; 3], ...
%!              'tolRes', [0.01; 0.01; 0.02]);
%! assert ([Case.targets.model], [1, 1, 2]);
%! assert ([Case.targets.tol], [0.01, 0.01, 0.02]);
%!error id=DEcalioc:checkCase:badLimits
%! newCase (setfield (raw, 'paramLims', [2, 0; 1, 10]));
%!test
%! % fields that nobody reads, and a bench without packings
%! other = setfield (raw, 'Input', 'colour', 'red');
%! Case = with (other, 'optim', 'myWeights', [1, 2]);
%! marks = {'Input.colour', 'optim.myWeights', 'DEMmodels/First ', ...
%!          'DEMmodels/Second '};
%! assert (numel (Case.notes), 4);
%! assert (! any (cellfun (@isempty, cellfun (@strfind, Case.notes, marks, ...
%!                                            'UniformOutput', false))));
%! % used in a comment is used, as nobody can tell what a script does
%! for model = {'First', 'Second'}
%!   folder = fullfile (raw.folder, 'DEMmodels', model{1}, 'lib');
%!   mkdir (folder);
%!   writeAtomic (fullfile (folder, 'insert.in'), 'seed ${runSeed}');
%! end
%! assert (newCase (raw).notes, cell (1, 0));
%! % a word that holds it is another one; no folder, no note
%! writeAtomic (fullfile (folder, 'insert.in'), 'seed ${runSeeds}');
%! assert (numel (newCase (raw).notes), 1);
%!test
%! % who reads alone needs no program and no place; mistakes are mistakes
%! raw = standInCase (tempname ());
%! raw.Input.store = '/proc/x';
%! raw.optim.targetVal = [400; 0.025; 3];     % getResults tells whose they are
%! raw.optim.tolRes = [0.01; 0.01; 0.02];
%! writeAtomic (fullfile (raw.folder, 'DEMmodels', 'First', 'runscript'), ...
%!              "noSuchDEM < in.First\n");
%! writeAtomic (fullfile (raw.folder, 'DEMmodels', 'First', 'in.First'), 'x');
%! ids = {checkCase(raw).id};
%! assert (ids, strcat ('DEcalioc:checkCase:', ...
%!                      {'missingProgram', 'storeNotWritable'}));
%! assert (size (checkCase (raw, 'reading')), [1, 0]);
%! home = getenv ('PATH');
%! setenv ('PATH', '/usr/bin:/bin');
%! tidy = onCleanup (@() setenv ('PATH', home));
%! raw.Input.executor = 'slurm';
%! assert ([newCase(raw, 'reading').targets.model], [1, 1, 2]);
%! raw.Input.numOfSam = 0;
%! assert ({checkCase(raw, 'reading').id}, {'DEcalioc:checkCase:badNumOfSam'});

% SPDX-License-Identifier: GPL-3.0-only
