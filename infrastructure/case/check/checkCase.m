% CHECKCASE  Finds all faults of a user's input before anything is run.
%
% CALL: [FAULTS, FOUND] = checkCase (RAW)
%       [FAULTS, FOUND] = checkCase (RAW, 'noPrograms')
%
%   RAW       what the user gave: a struct with the fields Input, optim,
%             modelVars, assign, paramLims (as loadInput returns them), folder
%             (case folder) and root (toolbox folder); anything else is a
%             fault too
%   FAULTS    1 x n struct array with the fields id ('DEcalioc:checkCase:...')
%             and message (what, where, expected, got, cure); empty where all
%             is good
%   FOUND     scalar struct of what the checks have read and newCase needs:
%             groups (of measured.csv, see groupMeasured; [] without one), sizes
%             (1 x M, targets of each model; [] where they make no sense)
%
% Never throws, starts no DEM run, makes no folder of the case, evaluates no
% text of the user. With 'noPrograms' no other program is started either: the
% results of getResults are not counted, bash does not read the runscript, and
% the place for the runs is not looked at. docs/inputs.md has a table of the
% identifiers.

function [faults, found] = checkCase (raw, mode)
  if nargin < 2
    mode = 'full';
  end
  found = struct ('groups', [], 'sizes', [], 'conditions', {{}});
  [faults, raw] = checkRaw (raw);
  if ~isempty (raw)
    [p, ~] = attempt (@() checkAlone (raw));
    [q, found] = attempt (@() checkTogether (raw, mode));
    faults = [faults, p, q];
  end
  if isempty (faults)
    faults = checkFault ();
  end
end

% An error in the checks themselves is a fault as well, not an exception.
function [p, found] = attempt (check)
  try
    [p, found] = check ();
  catch err
    found = struct ('groups', [], 'sizes', [], 'conditions', {{}});
    where = '';
    if ~isempty (err.stack)
      where = sprintf (' (%s, line %d)', err.stack(1).name, ...
                       err.stack(1).line);
    end
    p = checkFault ('checkFailed', 'The input', ...
                    'values that the checks understand', ...
                    [err.message, where], ...
                    'Compare loadInput.m with the one of the toolbox.');
  end
end

% Parts that are not usable at all become [].
function [p, raw] = checkRaw (raw)
  p = checkFault ();
  if ~checkIs ('struct', raw)
    p = checkFault ('badRaw', 'The input', 'one struct', checkShow (raw), ...
                    'Call loadCase, or newCase as its help says.');
    raw = [];
    return
  end
  for name = {'Input', 'optim', 'modelVars'}
    [q, raw] = checkPart (raw, name{1}, @(v) checkIs ('struct', v), ...
                          'one struct');
    p = [p, q];
  end
  for name = {'assign', 'paramLims'}
    [q, raw] = checkPart (raw, name{1}, @(v) true, 'a value');
    p = [p, q];
  end
  for name = {'folder', 'root'}
    [q, raw] = checkPart (raw, name{1}, @(v) checkIs ('text', v), ...
                          'the path of a folder');
    p = [p, q];
  end
end

function [p, raw] = checkPart (raw, name, isGood, expected)
  p = checkFault ();
  cure = 'Compare loadInput.m with the one of the toolbox.';
  if ~isfield (raw, name)
    p = checkFault ('missingOutput', name, expected, 'nothing', cure);
    raw.(name) = [];
  elseif ~isGood (raw.(name))
    p = checkFault ('notStruct', name, expected, ...
                    checkShow (raw.(name)), cure);
    raw.(name) = [];
  end
end

% Checks that look at the values alone.
function [p, found] = checkAlone (raw)
  found = [];
  numOfSam = [];
  if isstruct (raw.Input)
    numOfSam = givenField (raw.Input, 'numOfSam', []);
  end
  p = [checkSettings(raw.Input, raw.optim), ...
       checkVariables(raw.modelVars, raw.assign, raw.paramLims, numOfSam)];
end

% Checks that compare the values with files and with each other.
function [p, found] = checkTogether (raw, mode)
  p = checkFault ();
  found = struct ('groups', [], 'sizes', [], 'conditions', {{}});
  models = checkFindModels (struct (), '', '', mode);
  if isstruct (raw.Input) && ischar (raw.folder) && ischar (raw.root)
    models = checkFindModels (raw.Input, raw.folder, raw.root, mode);
    if needsModels (raw)
      executor = givenField (raw.Input, 'executor', 'local');
      how = struct ('programs', strcmp (mode, 'full'), 'onCluster', ...
                    checkIs ('text', executor) && ...
                    ~describeExecutor (executor).isHere);
      p = checkModels (models, raw.folder, raw.root, how);
    end
  end
  [ofLevels, names, fields] = checkLevels (raw, numel (models));
  [names, fields, kinds] = variablesOf (raw, names, fields);
  p = [p, checkDeclared(names, fields, kinds, models)];
  if isstruct (raw.optim)
    [q, found] = checkAllTargets (raw, models, names);
    p = [p, q, checkCorrelation(raw.optim, found.sizes)];
    if isstruct (raw.modelVars) && iscell (raw.assign)
      p = [p, checkRayleigh(raw.optim, raw.modelVars, raw.assign(:)', models)];
    end
    p = [p, checkMeasured(raw.optim, raw.assign, raw.paramLims)];
  end
  p = [p, ofLevels];
  if strcmp (mode, 'full')
    p = [p, checkPlace(raw, models)];
  end
end

% measured.csv goes before what optim says of the targets.
function [p, found] = checkAllTargets (raw, models, names)
  found = struct ('groups', [], 'sizes', [], 'conditions', {{}});
  file = '';
  if ischar (raw.folder)
    file = fullfile (raw.folder, 'measured.csv');
  end
  if isfile (file)
    [p, found] = checkMeasuredTable (raw, models, names);
    return
  end
  [p, found.sizes] = checkTargets (raw.optim, models);
  p = [p, checkPerTarget(raw.optim, found.sizes, names)];
end

% With a table of finished runs and no new ones the models need not be there.
function yes = needsModels (raw)
  yes = ~(isequal (givenField (raw.Input, 'maxNewRuns', Inf), 0) && ...
          isfile (fullfile (raw.folder, 'runs.csv')));
end

% Those of assign and modelVars, and those of the levels, which are given.
function [names, fields, kinds] = variablesOf (raw, names, fields)
  kinds = repmat ({'level'}, size (names));
  if isstruct (raw.modelVars)
    fixed = fieldnames (raw.modelVars)';
    names = [fixed, names];
    fields = [strcat('modelVars.', fixed), fields];
    kinds = [repmat({'fixed'}, size (fixed)), kinds];
  end
  if iscell (raw.assign)
    n = numel (raw.assign);
    names = [raw.assign(:)', names];
    fields = [arrayfun(@(k) sprintf ('assign{%d}', k), 1:n, ...
                       'UniformOutput', false), fields];
    kinds = [repmat({'design'}, 1, n), kinds];
  end
  isGood = cellfun (@(n) checkIs ('name', n) && ...
                    ~any (strcmp (n, {'RLTS', 'SIMTS', 'runSeed'})), names);
  [names, fields, kinds] = deal (names(isGood), fields(isGood), kinds(isGood));
end

function p = checkPlace (raw, models)
  p = checkFault ();
  if ~ischar (raw.folder) || ~isstruct (raw.Input)
    return
  end
  store = givenField (raw.Input, 'store', '');
  if ~checkIs ('text', store)
    store = raw.folder;
  end
  nRuns = countOr (raw.Input, 'numOfSam', 20);
  if isstruct (raw.optim)
    nRuns = nRuns + countOr (raw.optim, 'maxFunEvals', 40);
  end
  nRuns = min (nRuns, countOr (raw.Input, 'maxNewRuns', Inf));
  p = checkStore (store, raw.folder, models, nRuns);
end

function n = countOr (s, name, default)
  n = default;
  if isfield (s, name) && checkIs ('integer', s.(name)) && s.(name) >= 0
    n = double (s.(name));
  end
end

%!assert (checkCase (3).id, 'DEcalioc:checkCase:badRaw')
%!test
%! p = checkCase (struct ('Input', 1));
%! assert (all (strncmp ({p.id}, 'DEcalioc:checkCase:', 19)));
