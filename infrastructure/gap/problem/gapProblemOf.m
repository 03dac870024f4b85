% GAPPROBLEMOF  Describes a case in the terms of the diagnosis on matrices.
%
% CALL: [GIVEN, NOTES] = gapProblemOf (CASE)
%
%   CASE   see newCase, effects as of resolveEffects
%   GIVEN  struct for newGapProblem: the targets are its columns, the models its
%          benches; results.csv of a model gives series and coordinates
%   NOTES  cellstr, what had to be assumed
%
% Errors that are alike along a series of results.csv (optim.correlation) make
% GIVEN.covariance; where their length is to be estimated, GIVEN.estimateSeries
% says so (1 x T logical).
%
% Points of a curve of measured.csv are marked by GIVEN.curve. A setting that is
% not measured yet has the value NaN; its sd is what its measurement would be
% good to.
%
% A target without targetStd has an uncertainty of unknown size: GIVEN.sdKnown
% (1 x T logical) is false there, and half of its tolerance stands in GIVEN.sd
% as a first guess of the size. An
% effect of the laboratory becomes offset and matrix on the results, phi = 1 at
% the limit further from 0, the upper one of two that are as far. Members of an
% effect's group that the library knows but the case does not list are its
% siblings.
%
% See also: diagnoseGap, newGapProblem, addCorrelation

function [given, notes] = gapProblemOf (Case)
  notes = {};
  T = numel (Case.targets);
  given.value = [Case.targets.value];
  given.sd = [Case.targets.sd];
  bare = given.sd == 0;
  given.sdKnown = ~bare;
  if any (bare)
    scale = given.value;
    if isfield (Case.targets, 'isAbsolute')
      scale([Case.targets.isAbsolute]) = 1;
    end
    assumed = abs (scale) .* [Case.targets.tol] / 2;
    assumed(isnan (given.value)) = 0;
    given.sd(bare) = assumed(bare);
  end
  bare = bare & isfinite (given.value);
  if any (bare)
    notes{end + 1} = sprintf (['no measurement uncertainty given for %s: ' ...
                               'its size is estimated, starting from half ' ...
                               'of the tolerance (optim.targetStd)'], ...
                              strjoin (shortList (Case.targets(bare)), ', '));
  end
  given.targetNames = {Case.targets.name};
  given.trials = [Case.targets.trials];
  given.held = strcmp ({Case.targets.role}, 'holdout');
  given.bench = [Case.targets.model];
  given.benchNames = {Case.models.name};
  given.benchCost = [Case.models.cost];
  given.names = Case.names;
  given.limits = Case.limits;
  given.paramMean = Case.paramMean;
  given.paramSd = Case.paramSd;
  info = targetInfo (Case);
  series = {info.series};
  labels = arrayfun (@(t) sprintf ('%d/%s', given.bench(t), series{t}), 1:T, ...
                     'UniformOutput', false);
  [~, ~, number] = unique (labels);
  given.series = reshape (number, 1, T) .* ~cellfun (@isempty, series);
  at = [info.at];
  given.coordinate = at;
  given.coordinate(isnan (at)) = 0;
  given.series(isnan (at)) = 0;
  if isfield (Case.targets, 'curve')
    given.curve = [Case.targets.curve];
    given.scatter = [Case.targets.scatter];
  end
  [given, note] = addCorrelation (given, Case.targets);
  notes = [notes, note];
  library = struct ('name', {}, 'group', {});
  if ~isempty (Case.effects)
    library = libraryGroups (Case);
  end
  effects = [];
  for k = 1:numel (Case.effects)
    effects = [effects, oneEffect(Case.effects(k), info, given, library)];
  end
  given.effects = effects;
end

% A curve is one name.
function names = shortList (targets)
  names = {targets.name};
  if isfield (targets, 'curve')
    inCurve = [targets.curve] > 0;
    names(inCurve) = {targets(inCurve).series};
    names = unique (names, 'stable');
  end
end

function library = libraryGroups (Case)
  folders = fullfile (Case.folder, 'effects');
  names = listEffects (folders);
  library = struct ('name', {}, 'group', {});
  for k = 1:numel (names)
    effect = getEffect (names{k}, folders);
    library(k) = struct ('name', names{k}, 'group', effect.group);
  end
end

function e = oneEffect (effect, info, given, library)
  T = numel (info);
  e = struct ('name', effect.name, 'label', effect.label, ...
              'unit', effect.unit, 'group', effect.group, ...
              'variables', {effect.variables}, 'neutral', effect.neutral, ...
              'limits', effect.limits, 'laboratory', effect.laboratory, ...
              'siblings', {{}}, 'offset', zeros (1, T), ...
              'matrix', zeros (T), 'strongest', 1, 'range', [], ...
              'scale', 2);
  same = strcmp ({library.group}, effect.group) & ...
         ~strcmp ({library.name}, effect.name);
  e.siblings = {library(same).name};
  far = max (abs (effect.limits - effect.neutral), [], 1);
  ratio = effect.priorScale ./ far;
  if ~isempty (ratio) && all (isfinite (ratio)) && max (ratio) > 0
    e.scale = min (max (max (ratio), 0.1), 2);
  end
  if effect.laboratory
    [top, other] = furtherLimit (effect.limits);
    [e.offset, e.matrix] = linearPart (effect, top, info, given.bench);
    e.range = [min(other / top, 0), 1];
    e.strongest = top;
    e.limits = zeros (2, 0);
    e.variables = {};
    e.neutral = [];
  end
end

function [top, other] = furtherLimit (limits)
  top = limits(2);
  other = limits(1);
  if abs (other) > abs (top)
    [top, other] = deal (other, top);
  end
end

% A transform is affine in the results. One more result of every kind goes along
% so that no kind is missing; curves of different benches stay apart.
function [offset, matrix] = linearPart (effect, top, info, bench)
  T = numel (info);
  for t = 1:T
    if ~isempty (info(t).series)
      info(t).series = sprintf ('%s@%d', info(t).series, bench(t));
    end
  end
  for k = 1:numel (effect.kinds)
    extra = info(1);
    extra.kind = effect.kinds{k};
    extra.series = '';
    extra.at = 0;
    info = [info, extra];
  end
  n = numel (info);
  offset = effect.transform (zeros (1, n), top, info);
  unit = effect.transform (eye (n), top, info);
  matrix = unit(1:T, 1:T) - offset(1:T) - eye (T);
  offset = offset(1:T);
end

%!test
%! % a camera roll turns angles, a gain scales weights, other benches untouched
%! Case.targets = struct ('value', {1, 2}, 'sd', {0.1, 0}, 'tol', 0.1, ...
%!                        'name', {'a', 'b'}, 'role', 'calibrate', ...
%!                        'model', {1, 2}, 'index', 1, 'trials', {3, Inf}, ...
%!                        'correlation', 0);
%! folder = tempname ();
%! mkdir (folder);
%! Case.models = struct ('name', {'A', 'B'}, 'folder', ...
%!                       {fullfile(folder, 'A'), fullfile(folder, 'B')}, ...
%!                       'cost', {1, 7});
%! kinds = {'angle', 'mass'};
%! for k = 1:2
%!   mkdir (Case.models(k).folder);
%!   id = fopen (fullfile (Case.models(k).folder, 'results.csv'), 'w');
%!   fprintf (id, 'name,kind,unit,series,at,text\nr,%s,,,,x\n', kinds{k});
%!   fclose (id);
%! end
%! Case.folder = folder;
%! Case.names = {'mu'};
%! Case.limits = [0; 1];
%! [Case.paramMean, Case.paramSd] = deal (0.4, 0.1);
%! Case.effects = resolveEffects ({'cameraRoll', 'gain', 'cohesion'});
%! [given, notes] = gapProblemOf (Case);
%! % limits of the user's own: only too little, and mostly too little
%! Case.effects(2).limits = [-0.05; 0];
%! little = gapProblemOf (Case).effects(2);
%! Case.effects(2).limits = [-0.05; 0.01];
%! mostly = gapProblemOf (Case).effects(2);
%! Case.effects(2).limits = [-0.05; 0];
%! can = effectsOfModel (Case.models(2).folder, Case.effects(2));
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (folder, 's');
%! assert (given.effects(1).offset, [2, 0]);
%! assert (given.effects(2).matrix, [0, 0; 0, 0.05], 1e-12);
%! assert (little.matrix(2, 2), -0.05, 1e-12);
%! assert ([little.range, mostly.range], [0, 1, -0.2, 1], 1e-12);
%! assert ([little.strongest, mostly.strongest], [-0.05, -0.05]);
%! assert (can);
%! assert (ismember ('liquidBridge', given.effects(3).siblings));
%! assert (given.sd, [0.1, 0.1]);
%! assert (given.sdKnown, [true, false]);
%! assert (newGapProblem (given).sdKnown, [true, false]);
%! assert (given.trials, [3, Inf]);
%! assert (given.benchCost, [1, 7]);
%! assert ([given.paramMean, given.paramSd], [0.4, 0.1]);
%! assert (numel (notes), 1);
%! assert (! isempty (strfind (notes{1}, ['no measurement uncertainty ', ...
%!                             'given for b: its size is estimated'])));
%!test
%! % errors along a series of results.csv
%! Case.targets = struct ('value', 1, 'sd', {1, 2, 2}, 'tol', 0.1, ...
%!                        'name', {'a', 'b', 'c'}, 'role', 'calibrate', ...
%!                        'model', 1, 'index', {1, 2, 3}, 'trials', 1, ...
%!                        'correlation', 5);
%! folder = tempname ();
%! mkdir (folder);
%! Case.models = struct ('name', 'A', 'folder', folder, 'cost', 1);
%! writeAtomic (fullfile (folder, 'results.csv'), ...
%!              ["name,kind,unit,series,at,text\na,rate,kg/s,w,10,x\n", ...
%!               "b,rate,kg/s,w,15,x\nc,mass,kg,,,x\n"]);
%! Case.names = {'mu'};
%! Case.limits = [0; 1];
%! [Case.paramMean, Case.paramSd] = deal (NaN);
%! Case.effects = [];
%! given = gapProblemOf (Case);
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (folder, 's');
%! C = diag ([1, 4, 4]);
%! C(1, 2) = C(2, 1) = 2 / e;
%! assert (given.covariance, C, 1e-5);
