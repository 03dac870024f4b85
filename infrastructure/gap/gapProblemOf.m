% GAPPROBLEMOF  Describes a case in the terms of the diagnosis on matrices.
%
% CALL: [GIVEN, NOTES] = gapProblemOf (CASE)
%
%   CASE   see newCase, effects as of resolveEffects
%   GIVEN  struct for newGapProblem: the targets are its columns, the models its
%          benches; results.csv of a model gives series and coordinates
%   NOTES  cellstr, what had to be assumed
%
% A target without targetStd gets half of its tolerance as uncertainty. An
% effect of the laboratory becomes offset and matrix on the results, phi = 1 at
% its upper limit. Members of an effect's group that the library knows but the
% case does not list are its siblings.
%
% See also: diagnoseGap, newGapProblem

function [given, notes] = gapProblemOf (Case)
  notes = {};
  T = numel (Case.targets);
  given.y = [Case.targets.value];
  given.sd = [Case.targets.sd];
  bare = given.sd == 0;
  if any (bare)
    assumed = abs (given.y) .* [Case.targets.tol] / 2;
    given.sd(bare) = assumed(bare);
    notes{end + 1} = sprintf (['no measurement uncertainty (targetStd) for ' ...
                               '%s: half of the tolerance is taken'], ...
                              strjoin ({Case.targets(bare).name}, ', '));
  end
  given.targetNames = {Case.targets.name};
  given.held = strcmp ({Case.targets.role}, 'holdout');
  given.bench = [Case.targets.model];
  given.benchNames = {Case.models.name};
  given.names = Case.names;
  given.limits = Case.limits;
  info = infoOf (Case);
  series = {info.series};
  labels = arrayfun (@(t) sprintf ('%d/%s', given.bench(t), series{t}), 1:T, ...
                     'UniformOutput', false);
  [~, ~, number] = unique (labels);
  given.series = reshape (number, 1, T) .* ~cellfun (@isempty, series);
  at = [info.at];
  given.coordinate = at;
  given.coordinate(isnan (at)) = 0;
  given.series(isnan (at)) = 0;
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

% What each target is; models without results.csv say nothing.
function info = infoOf (Case)
  blank = struct ('name', '', 'kind', '', 'unit', '', 'series', '', ...
                  'at', NaN, 'text', '');
  info = repmat (blank, 1, numel (Case.targets));
  for k = 1:numel (Case.models)
    own = resultInfo (Case.models(k).folder);
    for t = find ([Case.targets.model] == k)
      if numel (own) >= Case.targets(t).index
        info(t) = own(Case.targets(t).index);
      end
    end
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
              'matrix', zeros (T), 'range', [], 'scale', 0.5);
  same = strcmp ({library.group}, effect.group) & ...
         ~strcmp ({library.name}, effect.name);
  e.siblings = {library(same).name};
  far = max (abs (effect.limits - effect.neutral), [], 1);
  ratio = effect.priorScale ./ max (far, eps);
  if ~isempty (ratio) && all (isfinite (ratio)) && max (ratio) > 0
    e.scale = min (max (max (ratio), 0.1), 2);
  end
  if effect.laboratory
    top = effect.limits(2);
    for b = unique (given.bench)
      at = find (given.bench == b);
      e.offset(at) = effect.transform (zeros (1, numel (at)), top, info(at));
      unit = effect.transform (eye (numel (at)), top, info(at));
      e.matrix(at, at) = unit - e.offset(at) - eye (numel (at));
    end
    e.range = [min(effect.limits(1) / top, 0), 1];
    e.limits = zeros (2, 0);
    e.variables = {};
    e.neutral = [];
  end
end
