% RESULTINPUT  What decides a result, as it is kept beside it.
%
% CALL: INPUT = resultInput (CASE)
%
%   CASE   see newCase
%   INPUT  scalar struct: models (1 x M cell of structs name, cpu, key ('': it has
%          no runscript), lastRun: number of the last run folder, runs: see
%          countFinished), modelVars, options, digest (scalar struct of
%          texts, one a part of the input: differs where the part does)
%
% See also: changedInput

function input = resultInput (Case)
  hashes = repmat (struct ('input', '', 'files', '', 'funs', '', ...
                           'build', ''), 1, numel (Case.models));
  if all (cellfun (@isfolder, {Case.models.folder}))
    hashes = hashModels (Case);
  end
  % a model that nothing can run has none
  keys = {hashes.input};
  keys(~isfile (fullfile ({Case.models.folder}, 'runscript'))) = {''};
  last = cellfun (@(name) getLastFoldersNumber (runPlace (Case, name)), ...
                  {Case.models.name});
  models = struct ('name', {Case.models.name}, 'cpu', {Case.models.cpu}, ...
                   'key', keys, 'lastRun', num2cell (last));
  runs = arrayfun (@(m) countFinished (m, Case), models);
  [models.runs] = num2cell (runs){:};
  input = struct ('models', {num2cell(models)}, 'modelVars', Case.modelVars, ...
                  'options', Case.options, 'digest', digestOf (Case, hashes));
end

function d = digestOf (Case, hashes)
  T = Case.targets;
  files = {'costFunction.m', 'runs.csv'};
  texts = cellfun (@(name) checkReadText (fullfile (Case.folder, name)), ...
                   files, 'UniformOutput', false);
  d.targets = mark ({T.modelName}, {T.name}, rounded ([T.value]), ...
                    rounded ([T.sd]), [T.tol], {T.role}, {T.series}, ...
                    [T.at], {}, trialsOf(T){:});
  d.conditions = '';                     % a calibration is of the reference alone
  if ~isempty (Case.conditions)
    changed = [T.changed];
    d.conditions = mark (Case.conditions, rounded ([changed.value]), ...
                         rounded ([changed.sd]));
  end
  d.limits = mark (Case.names, Case.limits, Case.paramMean, Case.paramSd, ...
                   Case.perCondition, allowedOf(Case){:});
  d.model = mark ({hashes.files}, {hashes.funs}, ...
                  orderfields (toRounded (Case.modelVars)));
  d.LIGGGHTS = strjoin ({hashes.build}, ' ');
  d.levels = mark (Case.coarse);
  d.costFunction = mark (texts{1});
  d.runsTable = mark (texts{2});
  d.settings = mark (settingsOf (Case.options));
  d.effects = '';                        % '' where the case is without them
  if ~isempty (Case.effects)
    % a diagnosis leaves those out that no result can show
    [~, nowhere] = unexpressedEffects (Case);
    list = effectsOf (Case.effects(~(nowhere & [Case.effects.laboratory])));
    origin = givenField (Case.options, 'origin', '');
    d.effects = mark ([list, {origin}(~isempty (origin))]);
  end
end

% What is given in loadInput.m beside the values; nothing where all is as by default,
% so that the mark of a result stays. The trials of measured.csv show in sd.
function list = trialsOf (T)
  isTable = isfield (T, 'each');
  default = zeros (size (T));
  default(isTable & [T.curve] > 0) = NaN;
  list = {[T.trials], [T.correlation]};
  list = list([~isTable && any(list{1} ~= 1), ~isequaln(list{2}, default)]);
end

function list = allowedOf (Case)
  list = {};
  if ~isempty (Case.allowed)
    list = {Case.allowed.values, Case.allowed.texts};
  end
end

% The options that change the way to the result, not where its runs are made.
function s = settingsOf (options)
  names = {'numOfSam', 'seed', 'replicates', 'intervals', 'similar', ...
           'tolfun', 'maxIter', 'maxFunEvals', 'WRL', 'method', 'infill', ...
           'confidence'};
  s = cellfun (@(name) options.(name), names, 'UniformOutput', false);
end

function list = effectsOf (effects)
  list = {};
  for e = effects
    list{end + 1} = {e.name, e.variables, e.neutral, e.limits};
  end
end

% The mean of trials has last digits of the processor that added them up.
function x = rounded (x)
  if ~isempty (x)
    x(:) = sscanf (sprintf ('%.12g ', x), '%f');
  end
end

function v = toRounded (v)
  v = structfun (@toDigits, v, 'UniformOutput', false);
end

function text = mark (varargin)
  text = hash ('sha256', jsonencode (varargin))(1:16);
end

%!test
%! % each part by itself; what only says where runs are made is none
%! Case = readyCase ();
%! d = resultInput (Case).digest;
%! assert (resultInput (Case).digest, d);
%! differ = @(C) fieldnames (d)(~strcmp (struct2cell (d), ...
%!                              struct2cell (resultInput (C).digest)))';
%! other = Case;
%! other.options.maxCPU = 7;
%! other.options.executor = 'slurm';
%! assert (differ (other), cell (1, 0));
%! % another processor adds up a mean with another last digit
%! other.targets(2).value = other.targets(2).value * (1 + 4 * eps);
%! assert (differ (other), cell (1, 0));
%! other.targets(2).value = 77;
%! assert (differ (other), {'targets'});
%! other.limits(1) = -1;
%! other.options.seed = 9;
%! other.modelVars.x = 3;
%! assert (differ (other), {'targets', 'limits', 'model', 'settings'});
%! % conditions and listed values, trials, correlation of the errors
%! other = Case;
%! other.allowed = struct ('values', {{1:3, []}}, 'texts', {{'a < b'}}, 'share', 0.5);
%! assert (differ (other), {'limits'});
%! other = Case;
%! other.targets(1).trials = 5;
%! assert (differ (other), {'targets'});
%! other = Case;
%! other.targets(1).correlation = 3;
%! assert (differ (other), {'targets'});
%! other = Case;
%! [Case.effects, other.effects] = deal (resolveEffects ({'shape', 'speedError'}));
%! other.effects(2) = [];
%! assert (differ (other), {'effects'});
%! d = resultInput (Case).digest;
%! assert (resultInput (other).digest, d);
%! other.effects.limits(2) = 3;
%! assert (~strcmp (resultInput (other).digest.effects, d.effects));
%! [Case.effects, d] = deal ([], resultInput (setfield (Case, 'effects', [])).digest);
%! writeAtomic (fullfile (Case.folder, 'runs.csv'), 'x');
%! assert (differ (Case), {'runsTable'});

% SPDX-License-Identifier: GPL-3.0-only
