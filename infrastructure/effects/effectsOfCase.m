% EFFECTSOFCASE  The candidate effects of a case, as a problem holds them.
%
% CALL: GIVEN = effectsOfCase (GIVEN, CASE)
%
%   GIVEN  struct of newProblem with its targets and benches; comes back with
%          effects (1 x K, see newEffect; [] where CASE has none) and causes
%   CASE   see newCase, effects as of resolveEffects
%
% An effect of the laboratory becomes offset and matrix on the results, phi = 1
% at the limit further from 0, the upper one of two that are as far. Members of
% an effect's group that the library knows but the case does not list are its
% siblings.

function given = effectsOfCase (given, Case)
  given.effects = [];
  effects = givenField (Case, 'effects', []);
  if isempty (effects)
    return
  end
  info = targetInfo (Case);
  given.causes = listCauses ({fullfile(Case.folder, 'causes'), Case.folder});
  if ~isempty (givenField (givenField (Case, 'options', struct ()), 'origin', ''))
    given.causes = [];                   % the user knows it
  end
  library = libraryGroups (Case);
  [~, factors] = changeWords (effects);
  isChange = ~isempty (givenField (Case, 'conditions', {}));
  for k = 1:numel (effects)
    e = oneEffect (effects(k), info, given, library);
    if isChange
      e.factor = factors(k);
    end
    given.effects = [given.effects, e];
  end
end

function library = libraryGroups (Case)
  [names, all] = listEffects ({fullfile(Case.folder, 'effects'), Case.folder});
  library = struct ('name', {}, 'group', {});
  for k = 1:numel (names)
    group = givenField (all(k).row, 'group', '');
    if isempty (all(k).row)
      group = getEffect (names{k}, all).group;
    elseif isempty (group)
      group = names{k};                  % see describeEffect
    end
    library(k) = struct ('name', names{k}, 'group', group);
  end
end

function e = oneEffect (effect, info, given, library)
  T = numel (info);
  e = struct ('name', effect.name, 'label', effect.label, ...
              'unit', effect.unit, 'saysName', givenField (effect, 'saysName', false), ...
              'group', effect.group, ...
              'variables', {effect.variables}, 'neutral', effect.neutral, ...
              'limits', effect.limits, 'laboratory', effect.laboratory, ...
              'siblings', {{}}, 'offset', zeros (1, T), ...
              'offsetSd', zeros (1, T), 'matrix', zeros (T), ...
              'strongest', 1, 'range', [], 'scale', 2, 'factor', 1, ...
              'oneSided', givenField (effect, 'oneSided', false));
  same = strcmp ({library.group}, effect.group) & ...
         ~strcmp ({library.name}, effect.name);
  e.siblings = {library(same).name};
  far = max (abs (effect.limits - effect.neutral), [], 1);
  ratio = effect.priorScale ./ far;
  if ~isempty (ratio) && all (isfinite (ratio)) && max (ratio) > 0
    e.scale = min (max (max (ratio), 0.1), 2);
  end
  if effect.laboratory
    ends = effect.limits([2, 1]);
    [~, further] = max (abs (ends));
    top = ends(further);
    [e.offset, e.matrix] = linearPart (effect, top, info, given.bench);
    e.range = [min(ends(3 - further) / top, 0), 1];
    e.strongest = top;
    e.limits = zeros (2, 0);
    e.variables = {};
    e.neutral = [];
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
  % not the diagonal matrix that eye is, which subtracts no row
  unit = effect.transform (full (eye (n)), top, info);
  matrix = unit(1:T, 1:T) - offset(1:T) - eye (T);
  offset = offset(1:T);
end

%!test
%! % a camera roll turns angles, a gain scales weights, other benches untouched
%! Case.targets = struct ('value', {1, 2}, 'sd', {0.1, 0}, 'tol', 0.1, ...
%!                        'name', {'a', 'b'}, 'role', 'calibrate', ...
%!                        'model', {1, 2}, 'index', 1, 'trials', {3, Inf}, ...
%!                        'correlation', 0);
%! folder = emptyFolder ();
%! Case.models = struct ('name', {'A', 'B'}, 'folder', ...
%!                       {fullfile(folder, 'A'), fullfile(folder, 'B')}, ...
%!                       'cost', {1, 7});
%! kinds = {'angle', 'mass'};
%! for k = 1:2
%!   mkdir (Case.models(k).folder);
%!   writeAtomic (fullfile (Case.models(k).folder, 'results.csv'), ...
%!     sprintf ("name,kind,unit,series,at,text\nr,%s,,,,x\n", kinds{k}));
%! end
%! Case.folder = folder;
%! [Case.names, Case.limits] = deal ({'mu'}, [0; 1]);
%! [Case.paramMean, Case.paramSd] = deal (0.4, 0.1);
%! Case.effects = resolveEffects ({'cameraRoll', 'gain', 'cohesion'});
%! [given, notes] = newProblem (Case);
%! assert (effectsOfModel (Case.models(2).folder, Case.effects(2)));
%! % limits of the user's own: only too little, and mostly too little
%! Case.effects(2).limits = [-0.05; 0];
%! little = newProblem (Case).effects(2);
%! Case.effects(2).limits = [-0.05; 0.01];
%! mostly = newProblem (Case).effects(2);
%! assert (given.effects(1).offset, [2, 0]);
%! assert (given.effects(2).matrix, [0, 0; 0, 0.05], 1e-12);
%! assert (little.matrix(2, 2), -0.05, 1e-12);
%! assert ([little.range, mostly.range], [0, 1, -0.2, 1], 1e-12);
%! assert ([little.strongest, mostly.strongest], [-0.05, -0.05]);
%! assert (ismember ('liquidBridge', given.effects(3).siblings));
%! assert ([given.effects.saysName], [false, false, true]);
%! assert (given.sdKnown, [true, false]);
%! assert ({given.sd, given.trials, given.benchCost}, ...
%!         {[0.1, 0.1], [3, Inf], [1, 7]});
%! assert ([given.paramMean, given.paramSd], [0.4, 0.1]);
%! assert (numel (notes), 1);
%! assert (! isempty (strfind (notes{1}, ['no measurement uncertainty ', ...
%!                             'given for b: its size is estimated'])));

% SPDX-License-Identifier: GPL-3.0-only
