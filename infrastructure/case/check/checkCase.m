% CHECKCASE  Finds all faults of a user's input before anything is run.
%
% CALL: [FAULTS, FOUND] = checkCase (RAW)
%       [FAULTS, FOUND] = checkCase (RAW, 'reading')
%       [FAULTS, FOUND] = checkCase (RAW, 'noPrograms')
%
%   RAW       what the user gave: a struct with the fields Input, optim,
%             modelVars, assign, paramLims (as loadInput returns them), folder
%             (case folder) and root (toolbox folder); anything else is a
%             fault too
%   FAULTS    1 x n struct array with the fields id ('DEcalioc:checkCase:...')
%             and message (what, where, expected, got, cure); empty where all
%             is good
%   FOUND     scalar struct of what newCase needs of it: groups, conditions,
%             sizes (see checkMeasuredTable), paramMean, paramSd (see
%             checkMeasured), box (see checkBox)
%
% Never throws, starts no DEM run, makes no folder of the case, evaluates no
% text of the user. With 'reading', for what reads the files of a case alone, a
% program that runs need is no fault where it is not there, bash does not read
% the runscript, and the place for the runs is not looked at. With 'noPrograms'
% no other program is started at all: the results of getResults are not counted
% either. Reasons: see docs/inputs.md.

function [faults, found] = checkCase (raw, mode)
  if nargin < 2
    mode = 'full';
  end
  found = struct ('groups', [], 'sizes', [], 'conditions', {{}}, ...
                  'sessions', struct ('given', false, 'names', {{}}, ...
                                      'ratio', 0, 'df', 0));
  [faults, raw, isUsable] = checkRaw (raw);
  if ~isUsable
    return
  end
  try
    faults = [faults, checkSettings(raw.Input, raw.optim), ...
              checkVariables(raw.modelVars, raw.assign, raw.paramLims, ...
                             givenField (raw.Input, 'numOfSam', []))];
    [p, found] = checkTogether (raw, mode, found);
    faults = [faults, p];
  catch err
    % an error in the checks themselves is a fault as well, not an exception
    got = err.message;
    if ~isempty (err.stack)
      got = sprintf ('%s (%s, line %d)', got, err.stack(1).name, ...
                     err.stack(1).line);
    end
    p = checkFault ('checkFailed', 'The input', ...
                    'values that the checks understand', got, ...
                    'Compare loadInput.m with the one of the toolbox.');
    faults = [faults, p];
  end
  if strcmp (mode, 'reading') && ~isempty (faults)
    faults(strcmp ({faults.id}, 'DEcalioc:checkCase:missingProgram')) = [];
  end
  if isempty (faults)
    faults = checkFault ();          % joined, empty ones have lost their fields
  end
end

% Parts of loadInput that are not usable at all become [].
function [p, raw, isUsable] = checkRaw (raw)
  isUsable = isKind ('struct', raw);
  if ~isUsable
    p = checkFault ('badRaw', 'The input', 'one struct', describeValue (raw), ...
                    'Call loadCase, or newCase as its help says.');
    return
  end
  p = checkFault ();
  one = 'one struct';
  path = 'the path of a folder';
  parts = {'Input', 'struct', one; 'optim', 'struct', one; ...
           'modelVars', 'struct', one; 'assign', '', 'a value'; ...
           'paramLims', '', 'a value'; 'folder', 'text', path; ...
           'root', 'text', path};
  cure = 'Compare loadInput.m with the one of the toolbox.';
  for part = parts'
    [name, kind, expected] = part{:};
    if ~isfield (raw, name)
      p(end + 1) = checkFault ('missingOutput', name, expected, 'nothing', ...
                               cure);
      raw.(name) = [];
    elseif ~isempty (kind) && ~isKind (kind, raw.(name))
      p(end + 1) = checkFault ('notStruct', name, expected, ...
                               describeValue (raw.(name)), cure);
      raw.(name) = [];
    end
  end
  isUsable = ischar (raw.folder) && ischar (raw.root);
end

% Checks that compare the values with files and with each other.
function [p, found] = checkTogether (raw, mode, found)
  p = checkFault ();
  models = checkFindModels (raw.Input, raw.folder, raw.root, mode, raw.assign);
  % with a table of finished runs and no new ones they need not be there
  if ~(isequal (givenField (raw.Input, 'maxNewRuns', Inf), 0) && ...
       isfile (fullfile (raw.folder, 'runs.csv')))
    executor = givenField (raw.Input, 'executor', ...
                           inputFields ('defaults').executor);
    isFar = isKind ('text', executor) && ~describeExecutor (executor).isHere;
    how = struct ('programs', strcmp (mode, 'full'), 'onCluster', isFar);
    p = checkModels (models, raw.folder, raw.root, how);
  end
  [ofLevels, names, fields] = checkLevels (raw, numel (models));
  [names, fields, kinds] = variablesOf (raw, names, fields);
  p = [p, checkDeclared(names, fields, kinds, models)];
  [ofBox, box] = checkBox (raw);
  p = [p, ofBox];
  if isstruct (raw.optim)
    [q, found] = checkMeasuredTable (raw, models, names);
    p = [p, q];
    [r, found.paramMean, found.paramSd] = ...
      checkMeasured (raw.optim, raw.assign, raw.paramLims);
    p = [p, checkRayleigh(raw.optim, raw.modelVars, raw.assign, models), r];
  end
  p = [p, ofLevels, checkShadow(raw.folder, raw.root)];
  found.box = box;
  if strcmp (mode, 'full')
    p = [p, checkPlace(raw, models)];
  end
end

% Radius, density, Young's modulus and Poisson's ratio must be among the model
% or the design variables where optim.WRL > 0, or where percentRayleigh is one
% and a data.head would keep its own time step otherwise. With optim.WRL > 0
% percentRayleigh too, where a data.head sets SIMTS to 0 and has no
% percentRayleigh to go by.
function p = checkRayleigh (optim, modelVars, assign, models)
  p = checkFault ();
  if ~isstruct (modelVars) || ~iscell (assign)
    return
  end
  isText = cellfun (@(a) isKind ('text', a), assign(:)');
  given = [fieldnames(modelVars)', assign(isText)(:)'];
  isWished = isfield (optim, 'WRL') && isKind ('number', optim.WRL) && ...
             optim.WRL > 0;
  isLost = any (strcmp (given, 'percentRayleigh')) && ...
           any (arrayfun (@ownStep, models) > 0);
  if ~isWished && ~isLost
    return
  end
  needed = {'radiusP', 'densityP', 'youngsModulusP', 'poissonsRatioP'};
  hasOwnShare = @(m) ~isempty (valueIn (m.head, 'percentRayleigh'));
  if isWished && any (arrayfun (@(m) ownStep (m) == 0 && ~hasOwnShare (m), ...
                                models))
    needed{end + 1} = 'percentRayleigh';
  end
  for k = find (~ismember (needed, given))
    name = needed{k};
    p(end + 1) = checkFault ('missingRayleigh', ['modelVars.', name], ...
                             'a number, or a design variable', ...
                             'neither', cure (name, models));
  end
end

% SIMTS of data.head (s); NaN where it has none.
function step = ownStep (model)
  step = str2double (valueIn (model.head, 'SIMTS'));
end

% The last line that names it counts; '' where none does.
function value = valueIn (head, name)
  value = '';
  if ~isempty (head) && any (strcmp ({head.name}, name))
    value = head(strcmp ({head.name}, name))(end).value;
  end
end

function text = cure (name, models)
  value = valueIn ([models.head], name);
  text = sprintf ('Set modelVars.%s = %s; as data.head does.', name, value);
  if isnan (str2double (value))
    text = ['Set modelVars.', name, '; without it optim.WRL must be 0 and ' ...
            'percentRayleigh not set.'];
  end
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
  isGood = cellfun (@(n) isKind ('name', n) && ...
                    ~any (strcmp (n, {'RLTS', 'SIMTS', 'runSeed'})), names);
  [names, fields, kinds] = deal (names(isGood), fields(isGood), kinds(isGood));
end

function p = checkPlace (raw, models)
  store = {raw.folder, givenField(raw.Input, 'store', '')};
  store = store{1 + isKind('text', store{2})};
  nRuns = countOr (raw.Input, 'numOfSam', 20) + ...
          countOr (raw.optim, 'maxFunEvals', 40);
  nRuns = min (nRuns, countOr (raw.Input, 'maxNewRuns', Inf));
  p = checkStore (store, raw.folder, models, nRuns);
end

function n = countOr (s, name, default)
  n = default;
  if isfield (s, name) && isKind ('integer', s.(name)) && s.(name) >= 0
    n = double (s.(name));
  end
end

%!function [text, n] = rayleighFaults (head, vars, WRL)
%!  raw = standInCase (tempname ());
%!  raw.modelVars = vars;
%!  raw.optim.WRL = WRL;
%!  for model = raw.Input.model
%!    file = fullfile (raw.folder, 'DEMmodels', model{1}, 'data.head');
%!    writeAtomic (file, [fileread(file), head]);
%!  end
%!  p = checkCase (raw, 'noPrograms');
%!  p = p(strcmp ({p.id}, 'DEcalioc:checkCase:missingRayleigh'));
%!  [text, n] = deal (strjoin ([{''}, p.message], ''), numel (p));
%!endfunction
%!assert (checkCase (3).id, 'DEcalioc:checkCase:badRaw')
%!test
%! p = checkCase (struct ('Input', 1));
%! assert (all (strncmp ({p.id}, 'DEcalioc:checkCase:', 19)));
%!test
%! % the second: a share of the Rayleigh time would be lost beside a fixed step
%! own = "variable radiusP equal 2e-3\nvariable SIMTS equal 0\n";
%! fixed = "variable SIMTS equal 1e-5\n";
%! most = struct ('youngsModulusP', 5e6, 'poissonsRatioP', 0.3, ...
%!                'densityP', 700);
%! share = struct ('percentRayleigh', 0.2, 'radiusP', 2e-3, ...
%!                 'youngsModulusP', 5e6, 'poissonsRatioP', 0.3);
%! [text, n] = rayleighFaults (own, most, 0.5);
%! assert ({n, isempty(strfind (text, 'radiusP = 2e-3;'))}, {2, false});
%! [text, n] = rayleighFaults (fixed, share, 0);
%! assert ({n, isempty(strfind (text, 'densityP'))}, {1, false});
%! assert (rayleighFaults (own, struct (), 0), '');
%! assert (rayleighFaults (fixed, setfield (share, 'densityP', 700), 0), '');

% SPDX-License-Identifier: GPL-3.0-only
