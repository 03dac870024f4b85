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
% results/progress.json is removed.
%
% Fields of calibration.json; a number that is not finite is null. Codes stay, sentences
% may change.
%
%   params, interval90, limits, scale: objects: of each parameter the value, [lower, upper],
%     'log' or 'linear'. constraints: list of texts. labels: what each parameter is.
%   targets, a list: model, name, label, role, target (null: not measured yet), sd (0: not
%     given), result (mean of the runs at these values; without any, of the surrogate),
%     resultSd (its standard error), residual (absolute where the tolerance is), noiseSd (of
%     one run), tol, allowed (half of the tolerance, in the unit), unit ('': not known), given
%     (the unit of measured.csv, which page and console show; '': the same), interval90 (of
%     the mean response), estimate (its middle, from runs and surrogate), state (met, missed:
%     runs and estimate agree; open: they do not, or no run exists; unjudged: too many runs
%     lack it; empty: not fitted), range (of all runs), met (state is met; without a run, by
%     the estimate; []: not fitted), curve (its series).
%   format: 1; it grows where a field changes its meaning or goes.
%   converged, reason: whether confirmed; one sentence.
%   ending: the same for programs: code (converged, conflict, allFailed, notRun, outside,
%     equalRuns, fewRuns, unsure, twoOutcomes, noResult, unjudged, open, published,
%     beyondScatter, cutOff, manyFailed, jump) with runs, equal, usual, other, none,
%     resulting, share, probability, conflict, limit, names (of what is open or unjudged: too
%     many runs lack it).
%   action: what to do: code, field, widen.
%   runs, probability: finished runs at these values; probability that the mean responses
%     meet all targets.
%   sources: own, imported, otherCases (parameter sets in the fit; those of a store
%     that is the case folder are own), misled (why a source is
%     left out; '').
%   outcomes: usual, other (runs that ended as most do, in another way), result (of the
%     others), none, resulting (runs without and with a result), share (expected of others),
%     alone (probability without others), onceMore (with all runs that the budget allows).
%   intervalCode, intervalNote: empty: interval90 may be used; else no fit (not printed),
%     unseen (no noise seen or given), few runs (of a curve), compromise (a value outside its
%     interval misses a target); a text.
%   demRuns, coreSeconds: plan, infill, verify (runs asked for), failed, reused (from the
%     store); CPU seconds of all these.
%   neverVaried (texts): parameters that are the same in all runs or rows of runs.csv, or follow
%     from others there: where no run can be added, they have no value, interval or share of
%     their own.
%   atLimit, notIdentified: parameters within 0.5 % of the range from a limit; with an
%     interval90 wider than half of the range. unfixed: combinations left open (texts). next:
%     further measurements, best first: code, kind, name, gain. known: parameters measured
%     separately: mean, sd.
%   sensitivity, correlation: per parameter, total Sobol index for each target; row of the
%     posterior's correlation. By name: sensitivity of each of targets, correlations ({a:
%     {b: r}}). surrogates: per target model, target, Q2, noiseSd.
%   levels: value, runs, seconds (core-seconds of a run), shift, shiftSd (response less that
%     at the last level, per target), noiseSd, dropped; targets (by model and target: shift,
%     shiftSd, noiseSd).
%   holdout: per target not used in the fit name, model, target, result, sd, interval90 (where a
%     measurement should lie), inside, leftOpen (true: only other parameter values that the
%     targets allow bring it inside).
%   limit, conflict: what ended the search (maxFunEvals, maxNewRuns, maxIter; unsettled:
%     none of them, but what is left would not settle it; empty: converged); targets that
%     no values within the limits meet together. untested: values that the surrogates
%     propose, not run ([]: none).
%   verdict: what console, status and page say, with gap/gap.json if it exists: word,
%     sentence, gap, usable, usableFor, notFor, action, numbers (label, text), met of of
%     targets, misses (worst first), worst (model): help decideCase.
%   warnings: as printed. history: per step after the plan stage ('infill', 'DEM'),
%     iteration, params, residual (expected from all runs), ofRuns (of the mean of the DEM
%     runs with these values; null: none), runs (sets of values since the plan), probability;
%     by name values (of params), residuals and residualsOfRuns (by model and target).
%   input: models (name, cpu, key: hash of input files, CPUs and program, lastRun,
%     runs: how many up to it ended well), modelVars, options, digest (of each part of the
%     input, for status and the page).
%   version, date.
%
% See also: newCalibration, decideCase, writeGapJson

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
  c.sources = ownSources (c.sources, Case);
  out = mergeFields (out, c, {'outcomes', 'sources', 'form'});
  out = mergeFields (out, c, {'runs', 'probability', 'demRuns', ...
                              'coreSeconds', 'atLimit', 'notIdentified'});
  out.unfixed = c.identifiability.text;
  out.neverVaried = neverVaried (c.data, Case);
  out.next = num2cell (c.identifiability.next);
  out.sensitivity = named (num2cell (num2cell (c.sensitivity), 2));
  out.correlation = c.correlation;
  out.correlations = named (cellfun (@(row) named (num2cell (row(:))), ...
                                     num2cell (c.correlation, 2), 'UniformOutput', false));
  noiseSd = num2cell (sqrt ([c.surrogates.noiseVar]));
  out.surrogates = num2cell (struct ('model', {Case.targets.modelName}, ...
                                     'target', {Case.targets.name}, ...
                                     'Q2', {c.surrogates.Q2}, ...
                                     'noiseSd', noiseSd));
  out.holdout = num2cell (c.holdout);
  out.levels = eachOf (@(L) levelOf (L, Case.targets), c.levels);
  out.warnings = c.warnings;
  out.history = eachOf (@(step) stepOf (step, Case.targets, named), c.history);
  [out.input, changed] = inputOf (c, Case);
  out.version = toolboxVersion (Case.root);
  out.date = strftime ('%Y-%m-%d %H:%M', localtime (time ()));
  folder = fullfile (Case.folder, 'results');
  [~, ~] = mkdir (folder);
  writeTables (c, Case, folder);
  stored = storedResult (Case);
  stored.calibration = jsondecode (jsonencode (out));
  stored.changed = changed;
  v = decideStored (stored);
  out.action = v.todo;
  out.verdict = rmfield (v, {'cause', 'todo', 'actionParts'});
  writeAtomic (fullfile (folder, 'calibration.json'), ...
               [jsonencode(out), "\n"]);
  [~, ~] = unlink (fullfile (folder, 'progress.json'));
end

% Where the store is the case folder, runs of an earlier input are of this case, too.
function s = ownSources (s, Case)
  if strcmp (Case.store, Case.folder)
    [s.own, s.otherCases] = deal (s.own + s.otherCases, 0);
  end
end

% CHANGED  words of changedInput: the model, where it did while it ran.
function [input, changed] = inputOf (c, Case)
  input = resultInput (Case);
  changed = repmat ({'model'}, 1, givenField (c, 'isMixed', false));
  if ~isempty (changed)
    input.digest.model = '';
  end
end

% A parameter that came to the case later is the same in all runs made before it.
function texts = neverVaried (data, Case)
  X = data.X;
  width = diff (Case.limits(1:2, :));
  isSame = rows (X) > 1 & max (X, [], 1) - min (X, [], 1) <= 5e-3 * width;
  texts = cell (1, 0);
  for j = find (isSame)
    texts{end + 1} = sprintf ('%s was never varied: it is %.6g in all runs', ...
                              Case.names{j}, X(1, j));
  end
  if isfield (Case, 'fixed')
    texts = [{Case.fixed.text}, texts];
  end
end

% What stands in lists in the order of targets and parameters, by name.
function step = stepOf (step, targets, named)
  step.values = named (num2cell (step.params(:)));
  step.residuals = byTarget (targets, num2cell (step.residual));
  step.residualsOfRuns = byTarget (targets, num2cell (step.ofRuns));
end

function L = levelOf (L, targets)
  L.targets = byTarget (targets, num2cell (struct ('shift', num2cell (L.shift), ...
                                                   'shiftSd', num2cell (L.shiftSd), ...
                                                   'noiseSd', num2cell (L.noiseSd))));
end

function targets = targetsOf (c, Case)
  T = Case.targets;
  ofParams = @(s) cell2struct (num2cell (s), Case.names, 1);
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
                              'resultSd', row (c.resultSd), 'curve', curve, ...
                              'range', eachOf (@(s) [min(s.z), max(s.z)], c.surrogates), ...
                              'sensitivity', eachOf (ofParams, ...
                                                     num2cell (c.sensitivity, 1))));
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
                "\n", headLines(v), heldWith(Case.models, v)]);
  saveSurrogates (c.surrogates, fullfile (folder, 'surrogates'), false);
end

% What else describes the material in the models, and was not looked for.
function text = heldWith (models, v)
  text = '';
  for model = models(:)'
    file = fullfile (model.folder, 'data.head');
    if isempty (model.folder) || ~isfile (file)
      continue
    end
    head = headDefaults (file);
    names = regexp (fieldnames (head)', '^(?:coef|youngs|poissons)\w*', 'match', 'once');
    names = setdiff (names, [fieldnames(v)', {''}], 'stable');
    values = eachOf (@(n) sprintf ('%s %.4g', n, head.(n)), names);
    if ~isempty (values)
      text = sprintf ('%s# with, of data.head of %s: %s\n', text, model.name, ...
                      strjoin (values, ', '));
    end
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
%!    "variable radiusP equal 1  # m\nvariable a equal 1\n", ...
%!    "variable youngsModulusP equal 5e6  # Pa\n"]);
%! c = newCalibration (state, problem, Case);
%! c.history = struct ('params', [5, 6], 'residual', [0.1; 0.2], 'ofRuns', [NaN; NaN]);
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
%! assert (isempty (out.neverVaried));
%! assert ([out.targets.allowed], [0.08, 0.04], 1e-12);
%! assert ([out.targets.met], c.met);
%! assert (out.targets(2).interval90, c.resultInterval90(:, 2), 1e-12);
%! assert (out.params.a, c.params(2), 1e-12);
%! assert (out.interval90.a, c.interval90(:, 2), 1e-12);
%! assert (out.sensitivity.a', c.sensitivity(2, :), 1e-12);
%! % by name what stands in lists in some order
%! assert (out.targets(2).sensitivity.a, c.sensitivity(2, 2), 1e-12);
%! assert (out.correlations.a.radiusP, c.correlation(2, 1), 1e-12);
%! assert (out.history.values.a, 6);
%! assert (out.history.residuals.First.(Case.targets(1).name), 0.1);
%! assert (isempty (out.history.residualsOfRuns.First.(Case.targets(1).name)));
%! % within half of the last digit that is known
%! step = 10^floor (log10 (min (diff (c.interval90(:, 1)) / 100, c.params(1) / 1000)));
%! assert (headDefaults (read ('calibrated.head')).radiusP, c.params(1), ...
%!         0.5 * step + 1e-12);
%! assert (! isempty (strfind (fileread (read ('calibrated.head')), ...
%!         "\n# with, of data.head of First: youngsModulusP 5e+06\n")));
%! assert (size (dlmread (read ('posterior.csv'), ',', 1, 0)), [1000, 2]);
%! % a parameter that came later, and runs that were made for the earlier input
%! c.data.X(:, 2) = 3;
%! c.data.stage(:) = {'library'};
%! [c.sources.own, c.sources.otherCases] = deal (0, 8);
%! for store = {Case.folder, '/another'}
%!   Case.store = store{1};
%!   writeCalibrationJson (c, Case);
%!   out = jsondecode (fileread (read ('calibration.json')));
%!   assert (out.sources.otherCases, 8 * strcmp (store{1}, '/another'));
%!   assert (out.sources.own + out.sources.otherCases, 8);
%! end
%! assert (out.neverVaried, {'a was never varied: it is 3 in all runs'});

% SPDX-License-Identifier: GPL-3.0-only
