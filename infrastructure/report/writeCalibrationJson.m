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
  out = struct ('format', 1, 'params', named (num2cell (c.params(:))));
  out.interval90 = named (num2cell (c.interval90, 1)');
  out = mergeFields (out, c, {'intervalNote', 'intervalCode'});
  out.limits = named (num2cell (Case.limits(1:2, :), 1)');
  words = {'linear', 'log'};
  out.scale = named (words(1 + any (Case.limits(3:end, :), 1))');
  out.constraints = {};
  if ~isempty (Case.allowed)
    out.constraints = Case.allowed.texts;
  end
  out.targets = targetsOf (c, Case);
  out = mergeFields (out, c, {'converged', 'ending', 'reason', 'limit', ...
                              'conflict'});
  out.ending = rmfield (out.ending, 'text');
  out.untested = [];
  if ~isempty (c.untested)
    out.untested = named (num2cell (c.untested(:)));
  end
  out.known = knownOf (Case);
  out.labels = named (paramLabels (Case));
  out = mergeFields (out, c, {'outcomes', 'sources', 'form'});
  out = mergeFields (out, c, {'runs', 'probability', 'demRuns', ...
                              'coreSeconds', 'atLimit', 'notIdentified'});
  out.unfixed = c.identifiability.text;
  out.neverVaried = {};
  if isfield (Case, 'fixed')
    out.neverVaried = {Case.fixed.text};
  end
  out.next = num2cell (c.identifiability.next);
  out.sensitivity = named (num2cell (num2cell (c.sensitivity), 2));
  out.correlation = c.correlation;
  noiseSd = num2cell (sqrt ([c.surrogates.noiseVar]));
  out.surrogates = num2cell (struct ('model', {Case.targets.modelName}, ...
                                     'target', {Case.targets.name}, ...
                                     'Q2', {c.surrogates.Q2}, ...
                                     'noiseSd', noiseSd));
  out.holdout = num2cell (c.holdout);
  out.levels = num2cell (c.levels);
  out.warnings = c.warnings;
  out.history = num2cell (c.history);
  out.input = resultInput (Case);
  out.version = toolboxVersion (Case.root);
  out.date = strftime ('%Y-%m-%d %H:%M', localtime (time ()));
  folder = fullfile (Case.folder, 'results');
  [~, ~] = mkdir (folder);
  writeTables (c, Case, folder);
  stored = storedResult (Case);
  stored.calibration = jsondecode (jsonencode (out));
  stored.changed = {};
  v = decideStored (stored);
  out.action = v.todo;
  out.verdict = rmfield (v, {'cause', 'todo', 'actionParts'});
  writeAtomic (fullfile (folder, 'calibration.json'), ...
               [jsonencode(out), "\n"]);
  [~, ~] = unlink (fullfile (folder, 'progress.json'));
end

function targets = targetsOf (c, Case)
  T = Case.targets;
  info = targetInfo (Case);
  isFit = strcmp ({T.role}, 'calibrate');
  row = @(values) num2cell (values(:)');
  [met, state, curve] = deal (row (c.met), c.state, {T.series});
  met(~isFit) = {[]};
  state(~isFit & ~strcmp (c.state, 'unjudged')) = {''};
  curve([T.curve] == 0) = {''};
  given = repmat ({''}, size (T));
  if isfield (T, 'given')
    given = {T.given};
  end
  targets = num2cell (struct ('model', {T.modelName}, 'name', {T.name}, ...
                              'given', given, ...
                              'label', {info.text}, ...
                              'role', {T.role}, 'target', {T.value}, 'sd', {T.sd}, ...
                              'tol', {T.tol}, ...
                              'unit', regexprep ({info.unit}, '^-$', ''), ...
                              'result', row (c.results), 'residual', row (c.residual), ...
                              'noiseSd', row (c.noiseSd), ...
                              'interval90', num2cell (c.resultInterval90, 1), ...
                              'allowed', eachOf (@halfWidth, T), ...
                              'estimate', row (c.estimate), 'met', met, 'state', state, ...
                              'resultSd', row (c.resultSd), 'curve', curve));
end

% Parameters that were measured by themselves.
function known = knownOf (Case)
  known = struct ();
  for j = find (isfinite (Case.paramMean) & isfinite (Case.paramSd))
    known.(Case.names{j}) = struct ('mean', Case.paramMean(j), 'sd', Case.paramSd(j));
  end
end

function writeTables (c, Case, folder)
  targets = strrep ({Case.targets.name}, ',', ';');
  writeMatrix (fullfile (folder, 'sensitivity.csv'), c.sensitivity, targets);
  writeMatrix (fullfile (folder, 'correlation.csv'), c.correlation, ...
               Case.names);
  writeMatrix (fullfile (folder, 'posterior.csv'), c.posterior, Case.names);
  v = Case.modelVars;
  for level = Case.coarse
    v.(level.variable) = level.levels(end);
  end
  params = asKnown (c, Case.limits);
  v = assignParams (v, params, Case.names);
  for f = givenField (Case, 'fixed', [])   % those that follow from the others
    v.(f.name) = f.at(1) + params(:)' * f.at(2:end)';
  end
  writeAtomic (fullfile (folder, 'calibrated.head'), ...
               ['# ', resultTitle(c, strftime ('%Y-%m-%d', localtime (time ()))), ...
                "\n", headLines(v)]);
  place = fullfile (folder, 'surrogates');
  [~, ~] = mkdir (place);
  for t = 1:numel (c.surrogates)
    saveSurrogate (fullfile (place, sprintf ('KM_fun_%d.txt', t)), ...
                   c.surrogates(t));
  end
end

% With the digits that are known: to a hundredth of the interval, without one of the
% limits, but at least four. What was run to the last digit stands in the JSON.
function params = asKnown (c, limits)
  width = diff (c.interval90(1:2, :), 1, 1);
  none = ~(width > 0);
  width(none) = diff (limits(1:2, none), 1, 1);
  params = c.params;
  on = params ~= 0;
  step = 10.^floor (log10 (min (width(on) / 100, abs (params(on)) / 1000)));
  params(on) = step .* round (params(on) ./ step);
end

%!test
%! % the set, and what its parameters are, in words; with and without a remark
%! [problem, state] = smallCalibration ();
%! state.final = mergeFields (confirmSet (state, problem), ...
%!                            struct ('untested', []));
%! raw = standInCase (tempname ());
%! [raw.Input.model, raw.Input.cpu] = deal ({'First'}, 1);
%! [raw.optim.targetVal, raw.optim.tolRes] = deal ({[4, 2]}, 0.02);
%! Case = newCase (raw);
%! writeAtomic (fullfile (Case.models.folder, 'data.head'), ...
%!   ["variable lid equal 2 # kg, mass of the lid\n", ...
%!    "variable radiusP equal 1  # m\nvariable a equal 1\n"]);
%! c = newCalibration (state, problem, Case);
%! read = @(name) fullfile (Case.folder, 'results', name);
%! words = {'mass of the lid', 'friction of grains and walls'; ...
%!          'radius of the grains', ''};
%! names = {'lid', 'coefFrictionPW'; 'radiusP', 'a'};
%! for k = 1:2
%!   Case.names = names(k, :);
%!   v = writeCalibrationJson (c, Case);
%!   out = jsondecode (fileread (read ('calibration.json')));
%!   assert (struct2cell (out.labels)', words(k, :));
%! end
%! assert (out.verdict.word, v.word);
%! assert ([out.targets.allowed], [0.08, 0.04], 1e-12);
%! assert ([out.targets.met], c.met);
%! assert (out.targets(2).interval90, c.resultInterval90(:, 2), 1e-12);
%! assert (out.params.a, c.params(2), 1e-12);
%! assert (out.interval90.a, c.interval90(:, 2), 1e-12);
%! assert (out.sensitivity.a', c.sensitivity(2, :), 1e-12);
%! % within half of the last digit that is known
%! step = 10^floor (log10 (min (diff (c.interval90(:, 1)) / 100, c.params(1) / 1000)));
%! assert (headDefaults (read ('calibrated.head')).radiusP, c.params(1), ...
%!         0.5 * step + 1e-12);
%! assert (size (dlmread (read ('posterior.csv'), ',', 1, 0)), [1000, 2]);
