% WRITECALIBRATIONJSON  Writes results/calibration.json and tables beside it.
%
% CALL: V = writeCalibrationJson (C, CASE)
%
%   C     see newCalibration
%   CASE  see newCase
%   V     see decideCase: what is written as verdict
%
% sensitivity.csv holds total Sobol indices (one row a parameter, one column a
% target), correlation.csv the correlation of the parameters among the sets
% that fit, posterior.csv a sample of these sets, calibrated.head the lines of
% a data.head with the calibrated parameters, surrogates/ the last surrogates.
% The fields are described in docs/data.md. results/progress.json is removed.

function v = writeCalibrationJson (c, Case)
  named = @(values) cell2struct (values, Case.names, 1);
  out = struct ('params', named (num2cell (c.params(:))));
  out.interval90 = named (num2rows (c.interval90'));
  out.limits = named (num2rows (Case.limits'));
  out.targets = targetsOf (c, Case);
  out.converged = c.converged;
  out.reason = c.reason;
  out.limit = c.limit;
  out.conflict = c.conflict(:)';
  out.untested = [];
  if ~isempty (c.untested)
    out.untested = named (num2cell (c.untested(:)));
  end
  out.known = knownOf (Case);
  out.labels = named (parameterWords (Case)(:));
  out.runs = c.runs;
  out.probability = c.probability;
  out.demRuns = c.demRuns;
  out.coreSeconds = c.coreSeconds;
  out.atLimit = c.atLimit(:)';
  out.notIdentified = c.notIdentified(:)';
  out.unfixed = c.identifiability.text(:)';
  out.next = num2cell (c.identifiability.next(:)');
  out.sensitivity = named (num2rows (c.sensitivity));
  out.correlation = c.correlation;
  out.surrogates = surrogatesOf (c, Case);
  out.holdout = num2cell (c.holdout(:)');
  out.levels = num2cell (c.levels(:)');
  out.warnings = c.warnings(:)';
  out.history = num2cell (c.history(:)');
  out.input = inputOf (Case);
  out.version = toolboxVersion (Case.root);
  out.date = strftime ('%Y-%m-%d %H:%M', localtime (time ()));
  folder = fullfile (Case.folder, 'results');
  [~, ~] = mkdir (folder);
  writeTables (c, Case, folder);
  v = decideCase (jsondecode (jsonencode (out)), ...
                  readJsonFile (fullfile (Case.folder, 'gap', 'gap.json')));
  out.verdict = rmfield (v, 'cause');
  writeAtomic (fullfile (folder, 'calibration.json'), ...
               [jsonencode(out), "\n"]);
  [~, ~] = unlink (fullfile (folder, 'progress.json'));
end

% Rows of a matrix as a cell, each an array of the JSON file.
function parts = num2rows (M)
  parts = cell (rows (M), 1);
  for k = 1:rows (M)
    parts{k} = num2cell (M(k, :));
  end
end

function targets = targetsOf (c, Case)
  targets = cell (1, numel (Case.targets));
  units = regexprep ({targetInfo(Case).unit}, '^-$', '');
  for t = 1:numel (Case.targets)
    T = Case.targets(t);
    targets{t} = struct ('model', T.modelName, 'name', T.name, ...
                         'role', T.role, 'target', T.value, 'sd', T.sd, ...
                         'tol', T.tol, 'unit', units{t}, ...
                         'result', c.results(t), ...
                         'residual', c.residual(t), ...
                         'noiseSd', c.noiseSd(t), ...
                         'interval90', {num2cell(c.resultInterval90(:, t)')});
    targets{t}.allowed = halfWidth (T);
    targets{t}.estimate = c.estimate(t);
    targets{t}.met = [];
    if strcmp (T.role, 'calibrate')
      targets{t}.met = c.met(t);
    end
    targets{t}.curve = '';
    if isfield (T, 'curve') && T.curve > 0
      targets{t}.curve = T.series;
    end
  end
end

% Parameters that were measured by themselves.
function known = knownOf (Case)
  known = struct ();
  for j = find (isfinite (Case.paramMean) & isfinite (Case.paramSd))
    known.(Case.names{j}) = struct ('mean', Case.paramMean(j), ...
                                    'sd', Case.paramSd(j));
  end
end

function surrogates = surrogatesOf (c, Case)
  surrogates = cell (1, numel (Case.targets));
  for t = 1:numel (Case.targets)
    s = c.surrogates(t);
    surrogates{t} = struct ('model', Case.targets(t).modelName, ...
                            'target', Case.targets(t).name, ...
                            'Q2', s.Q2, 'noiseSd', sqrt (s.noiseVar));
  end
end

% What decides the result, so that it can be repeated.
function input = inputOf (Case)
  models = cell (1, numel (Case.models));
  keys = keysOf (Case);
  for k = 1:numel (models)
    models{k} = struct ('name', Case.models(k).name, ...
                        'cpu', Case.models(k).cpu, 'key', keys{k});
  end
  input = struct ('models', {models}, 'modelVars', Case.modelVars, ...
                  'options', Case.options);
end

function keys = keysOf (Case)
  keys = repmat ({''}, 1, numel (Case.models));
  if all (cellfun (@isfolder, {Case.models.folder}))
    keys = {hashModels(Case).input};
  end
end

function writeTables (c, Case, folder)
  targets = strrep ({Case.targets.name}, ',', ';');
  writeMatrix (fullfile (folder, 'sensitivity.csv'), c.sensitivity, targets);
  writeMatrix (fullfile (folder, 'correlation.csv'), c.correlation, ...
               Case.names);
  writeMatrix (fullfile (folder, 'posterior.csv'), c.posterior, Case.names);
  v = Case.modelVars;
  for own = Case.coarse
    v.(own.variable) = own.levels(end);
  end
  v = designVariables (v, c.params, Case.names);
  writeAtomic (fullfile (folder, 'calibrated.head'), headLines (v));
  place = fullfile (folder, 'surrogates');
  [~, ~] = mkdir (place);
  for t = 1:numel (c.surrogates)
    saveSurrogate (fullfile (place, sprintf ('KM_fun_%d.txt', t)), ...
                   c.surrogates(t));
  end
end
