% TARGETSOFCASE  The targets of a case, as the fields of a problem.
%
% CALL: GIVEN = targetsOfCase (CASE)
%
%   CASE   see newCase; of its targets what a test needs is enough
%   GIVEN  struct with fields of newProblem: of targets and benches, sd guessed
%          where none is stated, coarse and fine

function given = targetsOfCase (Case)
  targets = arrayfun (@(t) mergeFields (oneTarget (), t), Case.targets, ...
                      'UniformOutput', false);
  targets = [targets{:}];
  given = fieldsOf (targets);
  info = targets;
  if isfield (Case, 'models')
    given.benchNames = {Case.models.name};
    given.benchCost = [Case.models.cost];
    info = targetInfo (Case);
  end
  given = withSeries (given, info);
  if isfield (Case, 'models')
    given.reading = readingsOf (info, given);
  end
  [given.coarse, given.fine] = levelsOf (givenField (Case, 'coarse', []), ...
                                         targets);
end

function [coarse, fine] = levelsOf (given, targets)
  coarse = [];
  fine = zeros (1, 0);
  if isempty (given)
    return
  end
  coarse.variables = {given.variable};
  coarse.levels = vertcat (given.levels)';
  coarse.column = zeros (1, numel (targets));
  for k = 1:numel (given)
    coarse.column(ismember ([targets.model], given(k).models)) = k;
  end
  fine = coarse.levels(end, :);
end

% A target of which a test says no more than it needs.
function target = oneTarget ()
  target = struct ('name', '', 'value', NaN, 'sd', 0, 'tol', 0.01, ...
                   'isAbsolute', false, 'trials', 1, 'scatter', false, ...
                   'shared', 0, 'days', [], 'freedom', Inf, ...
                   'commonFreedom', Inf, 'sessionFreedom', Inf, ...
                   'role', 'calibrate', 'model', 1, 'series', '', 'at', NaN, ...
                   'curve', 0, 'correlation', 0);
end

function given = fieldsOf (targets)
  for name = {'value', 'sd', 'tol', 'trials', 'curve', 'correlation', ...
              'shared', 'freedom', 'commonFreedom', 'sessionFreedom'}
    given.(name{1}) = double ([targets.(name{1})]);
  end
  given.scatter = logical ([targets.scatter]);
  given.bench = [targets.model];
  given.scale = given.value;
  given.scale(logical ([targets.isAbsolute])) = 1;
  given.held = strcmp ({targets.role}, 'holdout');
  given.calibrate = strcmp ({targets.role}, 'calibrate');
  given.targetNames = {targets.name};
  for t = find (cellfun (@isempty, given.targetNames))
    given.targetNames{t} = sprintf ('target_%d', t);
  end
  given = withGuess (given);
end

% A tolerance is seldom far from what can be measured: half of it is the first
% guess, from which the diagnosis estimates the size.
function given = withGuess (given)
  given.sdKnown = given.sd ~= 0;
  guess = abs (given.scale) .* given.tol / 2;
  guess(isnan (given.value)) = 0;
  given.sd(~given.sdKnown) = guess(~given.sdKnown);
end

% Quantities along a coordinate, those of different benches apart.
function given = withSeries (given, info)
  given.seriesNames = {info.series};
  given.coordinate = [info.at];
  isOn = ~cellfun (@isempty, given.seriesNames) & ...
         ~isnan (given.coordinate);
  labels = arrayfun (@(t, s) sprintf ('%d/%s', t, s{1}), given.bench, ...
                     given.seriesNames, 'UniformOutput', false);
  [~, ~, number] = unique (labels);
  given.series = reshape (number, size (isOn)) .* isOn;
  given.coordinate(isnan (given.coordinate)) = 0;
end

% Which targets one rule reads off: each curve, else the kind (length, angle, time ...), else
% the unit, else ''.
function readings = readingsOf (info, given)
  readings = {info.unit};
  for t = 1:numel (info)
    text = regexprep (info(t).kind, {'^(angleFalling|coneAngle)$', ...
                                     '^(offset|height|level)$'}, ...
                      {'angle', 'length'});
    if given.curve(t) > 0
      text = sprintf ('%s %s', given.benchNames{given.bench(t)}, ...
                      given.seriesNames{t});
    end
    if ~isempty (text)
      readings{t} = text;
    end
  end
end

%!test
%! % a guess where nothing is stated, and nothing to guess of what is missing
%! C.targets = struct ('value', {400, -4, NaN}, 'tol', 0.1, 'sd', {7, 0, 0});
%! given = targetsOfCase (C);
%! assert (given.sd, [7, 0.2, 0], 1e-12);
%! assert (given.sdKnown, [true, false, false]);
%! assert (given.targetNames{2}, 'target_2');
%!test
%! % what one rule reads off: curves, kinds, units
%! C.targets = struct ('value', 1, 'model', {1, 1, 1, 1, 2}, 'index', {1, 2, 3, 4, 1}, ...
%!                     'curve', {0, 0, 0, 0, 1});
%! C.models = struct ('name', {'A', 'B'}, 'cost', 1, 'folder', {emptyFolder(), emptyFolder()});
%! head = "name,kind,unit,series,at,text\n";
%! put = @(k, lines) writeAtomic (fullfile (C.models(k).folder, 'results.csv'), [head, lines]);
%! put (1, "a,coneAngle,deg,,,x\nb,level,m,,,x\nc,,g,,,x\ne,,,,,x\n");
%! put (2, "p,height,m,profile,1,x\n");
%! assert (targetsOfCase (C).reading, {'angle', 'length', 'g', '', 'B profile'});

% SPDX-License-Identifier: GPL-3.0-only
