% NEWCASE  Makes a case of what the user gave, with all defaults filled in.
%
% CALL: CASE = newCase (RAW)
%
%   RAW   struct with the fields Input, optim, modelVars, assign, paramLims
%         (as loadInput.m returns them), folder (case folder) and root (toolbox
%         folder), see readInput
%   CASE  scalar struct; its fields are described in docs/data.md. It has no
%         effects yet: withEffects adds them; the variables of its levels stand
%         first in effectVars, as they do in the data
%
% checkCase looks at RAW first. Its faults are raised together, as one
% error under the identifier of the first.
%
% Defaults: Input.seed 1, Input.executor 'local', Input.maxNewRuns Inf,
% Input.replicates 1, Input.coarse none, Input.store (folder
% that holds optim/) the case folder,
% Input.timeout none (a multiple
% of the median run), optim.tolfun 0.002, optim.maxIter 3, optim.maxFunEvals
% 40, optim.WRL 0, optim.method 'robust', optim.infill
% 'thompson', optim.confidence 0.95,
% optim.targetStd 0, optim.trials 1, optim.correlation 0 (independent),
% optim.role 'calibrate', optim.paramMean and paramSd NaN (not measured),
% optim.cost 1. A measured.csv in the case folder takes the place of the fields
% of optim that are given target by target.

function Case = newCase (raw)
  [faults, found] = checkCase (raw);
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
  Case.names = raw.assign(:)';
  Case.limits = double (raw.paramLims);
  Case.paramMean = rowByName (givenField (raw.optim, 'paramMean', []), ...
                              Case.names);
  Case.paramSd = rowByName (givenField (raw.optim, 'paramSd', []), Case.names);
  Case.modelVars = raw.modelVars;
  Case.effects = [];
  Case.coarse = newCoarse (givenField (Input, 'coarse', {}));
  [Case.models.coarse] = deal (Case.coarse);
  Case.effectVars = {Case.coarse.variable};
  Case.targets = newTargets (raw.optim, {Case.models.name}, found);
  Case.conditions = found.conditions;
  Case.perCondition = ismember (Case.names, ...
                                givenField (raw.optim, 'perCondition', {}));
  Case.options = newOptions (Input, raw.optim);
  Case.notes = caseNotes (raw, Case.models);
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
  text = sprintf ('%d problem(s) in the input, nothing has been run:\n%s', ...
                  numel (faults), strjoin (lines, "\n"));
end

function models = newModels (raw)
  names = cellstr (raw.Input.model);
  timeout = givenField (raw.Input, 'timeout', NaN);
  timeout(end + 1:numel (names)) = NaN;
  cost = givenField (raw.optim, 'cost', 1);
  cost(end + 1:numel (names)) = 1;
  models = struct ('name', names(:)', 'folder', '', 'cpu', 1, ...
                   'timeout', NaN, 'nTargets', 0, 'seconds', [], 'cost', 1, ...
                   'readings', []);
  for k = 1:numel (models)
    models(k).folder = findModel (models(k).name, raw.folder, raw.root);
    models(k).cpu = raw.Input.cpu(k);
    models(k).timeout = timeout(k);
    models(k).cost = double (cost(k));
  end
end

function o = newOptions (Input, optim)
  o.maxCPU = Input.maxCPU;
  o.numOfSam = Input.numOfSam;
  o.seed = givenField (Input, 'seed', 1);
  o.executor = givenField (Input, 'executor', 'local');
  o.maxNewRuns = givenField (Input, 'maxNewRuns', Inf);
  o.replicates = givenField (Input, 'replicates', 1);
  for name = executorNames ()
    if isfield (Input, name{1})
      o.(name{1}) = Input.(name{1});
    end
  end
  o.similar = givenField (Input, 'similar', '');
  if ~isempty (o.similar)
    o.similar = make_absolute_filename (tilde_expand (o.similar));
  end
  o.sets = describeExecutor (o.executor).sets (o);
  o.tolfun = givenField (optim, 'tolfun', 0.002);
  o.maxIter = givenField (optim, 'maxIter', 3);
  o.maxFunEvals = givenField (optim, 'maxFunEvals', 40);
  o.WRL = givenField (optim, 'WRL', 0);
  o.method = givenField (optim, 'method', 'robust');
  o.infill = givenField (optim, 'infill', 'thompson');
  o.confidence = givenField (optim, 'confidence', 0.95);
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
                               double (level.levels(:)'), 'models', []);
    end
    coarse(number).models(end + 1) = k;
  end
end

% What is no fault, but may be meant otherwise, in sentences for the user.
function notes = caseNotes (raw, models)
  [~, unread] = checkSettings (raw.Input, raw.optim);
  notes = strcat (unread, {[' in loadInput.m is read by nothing here, only ' ...
                            'by files of your own']});
  for model = models
    if ~isempty (model.folder) && ~usesSeed (model.folder)
      notes{end + 1} = ['no file of DEMmodels/', model.name, ' uses ' ...
                        'runSeed: all runs of a set are one and the same ' ...
                        'packing, and tell nothing of its scatter. Take ' ...
                        'insertion seeds from ${runSeed} (docs/extend.md)'];
    end
  end
end

% data.head only declares it.
function yes = usesSeed (folder)
  yes = system (['grep -RIqw --exclude=data.head runSeed ', ...
                 shellQuote(folder), ' 2> /dev/null']) == 0;
end

%!shared raw
%! raw = standInCase (tempname ());
%!test
%! Case = newCase (raw);
%! assert (size (Case.limits), [2, 2]);
%! assert ([Case.targets.value], [400, 0.025, 3]);
%! assert ([Case.targets.model], [1, 1, 2]);
%! assert ([Case.models.nTargets], [2, 1]);
%! assert ([Case.models.cost], [1, 1]);
%! assert ([Case.targets.trials], [1, 1, 1]);
%! assert (Case.options.seed, 1);
%!test
%! % trials: one number for a model, or one a target
%! repeated = raw;
%! repeated.optim.trials = {[], Inf};
%! assert ([newCase(repeated).targets.trials], [1, 1, Inf]);
%! repeated.optim.trials = {5, 2};
%! assert ([newCase(repeated).targets.trials], [5, 5, 2]);
%! repeated.optim.correlation = {[3, NaN], 'estimate'};
%! assert ([newCase(repeated).targets.correlation], [3, 0, NaN]);
%!test
%! measured = raw;
%! measured.optim.cost = 4;
%! assert ([newCase(measured).models.cost], [4, 1]);
%! assert (newCase (raw).paramSd, [NaN, NaN]);
%! measured.optim.paramMean = struct ('b', 2);
%! measured.optim.paramSd = [NaN; 0.5];
%! Case = newCase (measured);
%! assert ([Case.paramMean; Case.paramSd], [NaN, 2; NaN, 0.5]);
%!test
%! leveled = raw;
%! level = struct ('variable', 'e', 'levels', [3; 2]);
%! leveled.Input.coarse = {level, level};
%! assert (newCase (leveled).coarse, struct ('variable', 'e', ...
%!         'levels', [3, 2], 'models', [1, 2]));
%! assert (isempty (newCase (raw).coarse));
%!test
%! % the published file returns the values of all models as one column
%! published = raw;
%! published.optim.targetVal = horzcat (raw.optim.targetVal{:})';
%! published.optim.tolRes = horzcat (raw.optim.tolRes{:})';
%! Case = newCase (published);
%! assert ([Case.targets.model], [1, 1, 2]);
%! assert ([Case.targets.tol], [0.01, 0.01, 0.02]);
%!assert (isempty (newCase (raw).effects))
%!error id=DEcalioc:checkCase:badLimits
%! raw.paramLims(:, 1) = [2; 1];
%! newCase (raw);
%!test
%! % fields that nobody reads, and a bench without packings
%! raw = standInCase (tempname ());
%! raw.Input.colour = 'red';
%! raw.optim.myWeights = [1, 2];
%! Case = newCase (raw);
%! assert (numel (Case.notes), 4);
%! assert (! isempty (strfind (Case.notes{1}, 'Input.colour')));
%! assert (! isempty (strfind (Case.notes{2}, 'optim.myWeights')));
%! assert (! isempty (strfind (Case.notes{3}, 'DEMmodels/First ')));
%! % used in a comment is used, as nobody can tell what a script does
%! for model = {'First', 'Second'}
%!   folder = fullfile (raw.folder, 'DEMmodels', model{1}, 'lib');
%!   mkdir (folder);
%!   writeAtomic (fullfile (folder, 'insert.in'), 'seed ${runSeed}');
%! end
%! raw.Input = rmfield (raw.Input, 'colour');
%! raw.optim = rmfield (raw.optim, 'myWeights');
%! assert (newCase (raw).notes, cell (1, 0));
%! % a word that holds it is another one; no folder, no note
%! writeAtomic (fullfile (folder, 'insert.in'), 'seed ${runSeeds}');
%! assert (numel (newCase (raw).notes), 1);
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (raw.folder, 's');
