% GAPPROBLEMOF  The problem of a case, with what the diagnosis adds to it.
%
% CALL: [GIVEN, NOTES] = gapProblemOf (CASE [, C])
%
%   CASE   see newCase, effects as of resolveEffects
%   C      number of a condition of CASE: its values are the measured ones then,
%          those of CASE.targets the reference; without conditions no matter
%   GIVEN  struct for newGapProblem: that of newProblem (CASE), and sdKnown,
%          covariance, estimateSeries, reading, effects
%   NOTES  cellstr, what had to be assumed
%
% Errors that are alike along a series of results.csv (optim.correlation) make
% the covariance; where their length is to be estimated, estimateSeries says so.
% A length means nothing where the target has no neighbour on its series.
%
% A target without targetStd has an uncertainty of unknown size: sdKnown is
% false there, and half of its tolerance stands in sd as a first guess of it. An
% effect of the laboratory becomes offset and matrix on the results, phi = 1 at
% the limit further from 0, the upper one of two that are as far. Members of an
% effect's group that the library knows but the case does not list are its
% siblings.

function [given, notes] = gapProblemOf (Case, c)
  given = newProblem (Case);
  [given, note] = withGuessedSd (given);
  if nargin > 1 && ~isempty (Case.conditions)
    given = withCondition (given, Case, c);
  end
  [given, lost] = withCorrelation (given);
  notes = [note, lost];
  given.effects = [];
  info = targetInfo (Case);
  given.reading = readingsOf (info, given);
  if isempty (Case.effects)
    return
  end
  given.causes = listCauses (fullfile (Case.folder, 'causes'));
  library = libraryGroups (Case);
  [~, factors] = changeWords (Case.effects);
  isChange = ~isempty (givenField (Case, 'conditions', {}));
  for k = 1:numel (Case.effects)
    e = oneEffect (Case.effects(k), info, given, library);
    if isChange
      e.factor = factors(k);
    end
    given.effects = [given.effects, e];
  end
end

function [given, note] = withGuessedSd (given)
  note = {};
  bare = given.sd == 0;
  given.sdKnown = ~bare;
  guess = abs (given.scale) .* given.tol / 2;
  guess(isnan (given.value)) = 0;
  given.sd(bare) = guess(bare);
  bare = find (bare & isfinite (given.value));
  if ~isempty (bare)
    % a curve is one name
    names = given.targetNames(bare);
    inCurve = given.curve(bare) > 0;
    names(inCurve) = given.seriesNames(bare(inCurve));
    note = {sprintf(['no measurement uncertainty given for %s: its size ' ...
                     'is estimated, starting from half of the tolerance ' ...
                     '(optim.targetStd)'], ...
                    strjoin (unique (names, 'stable'), ', '))};
  end
end

function [given, note] = withCorrelation (given)
  note = {};
  lengths = given.correlation;
  isAsked = lengths ~= 0;
  % a length is learned from what is measured and fitted
  counts = isAsked & ~(isnan (lengths) & (isnan (given.value) | given.held));
  together = given.series' == given.series & given.series > 0 & ...
             counts' & isAsked;
  hasNeighbour = sum (together) > 1;
  given.estimateSeries = hasNeighbour & isnan (lengths);
  lengths(~hasNeighbour | isnan (lengths)) = 0;
  given.covariance = [];
  if any (lengths > 0 | given.shared > 0)
    given.covariance = measurementCovariance (given.sd, given.series, ...
                                              given.coordinate, lengths, ...
                                              given.shared);
  end
  lost = setdiff (given.bench(isAsked), given.bench(hasNeighbour));
  if ~isempty (lost)
    note = {['optim.correlation has no effect, for no two results are ' ...
             'measured, fitted and on one series (results.csv: series, ' ...
             'at), of ', strjoin(given.benchNames(lost), ', ')]};
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
              'offsetSd', zeros (1, T), 'matrix', zeros (T), ...
              'strongest', 1, 'range', [], 'scale', 2, 'factor', 1);
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
%! folder = tempname ();
%! mkdir (folder);
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
%! [given, notes] = gapProblemOf (Case);
%! assert (effectsOfModel (Case.models(2).folder, Case.effects(2)));
%! % limits of the user's own: only too little, and mostly too little
%! Case.effects(2).limits = [-0.05; 0];
%! little = gapProblemOf (Case).effects(2);
%! Case.effects(2).limits = [-0.05; 0.01];
%! mostly = gapProblemOf (Case).effects(2);
%! assert (given.effects(1).offset, [2, 0]);
%! assert (given.effects(2).matrix, [0, 0; 0, 0.05], 1e-12);
%! assert (little.matrix(2, 2), -0.05, 1e-12);
%! assert ([little.range, mostly.range], [0, 1, -0.2, 1], 1e-12);
%! assert ([little.strongest, mostly.strongest], [-0.05, -0.05]);
%! assert (ismember ('liquidBridge', given.effects(3).siblings));
%! assert (newGapProblem (given).sdKnown, [true, false]);
%! assert ({given.sd, given.trials, given.benchCost}, ...
%!         {[0.1, 0.1], [3, Inf], [1, 7]});
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
%! [Case.names, Case.limits] = deal ({'mu'}, [0; 1]);
%! [Case.paramMean, Case.paramSd] = deal (NaN);
%! Case.effects = [];
%! given = gapProblemOf (Case);
%! assert (given.covariance, [1, 2 / e, 0; 2 / e, 4, 0; 0, 0, 4], 1e-5);
%! assert (given.estimateSeries, false (1, 3));
%! % to be estimated: no covariance yet
%! [Case.targets.correlation] = deal (NaN);
%! [given, notes] = gapProblemOf (Case);
%! assert (isempty (given.covariance) && isempty (notes));
%! assert (given.estimateSeries, [true, true, false]);
%! % a neighbour that is not measured, or held out, tells no length
%! Case.targets(2).value = NaN;
%! [given, notes] = gapProblemOf (Case);
%! assert (given.estimateSeries, false (1, 3));
%! assert (! isempty (regexp (notes{1}, 'optim.correlation .* of A$')));
%! [Case.targets(2).value, Case.targets(2).role] = deal (1, 'holdout');
%! assert (gapProblemOf (Case).estimateSeries, false (1, 3));
%! % of a change: its condition, with the sd of the reference where it has none
%! [Case.perCondition, Case.conditions] = deal (true, {'moist'});
%! [Case.targets.changed] = deal (struct ('value', 7, 'sd', 0, 'trials', 3, ...
%!                                        'scatter', true));
%! given = gapProblemOf (Case, 1);
%! assert ([given.value; given.sd; given.trials; given.scatter], ...
%!         [7, 7, 7; 1, 2, 2; 3, 3, 3; 1, 1, 1]);
%! assert ({given.reference.value, given.reference.condition}, ...
%!         {[1, 1, 1], 'moist'});
