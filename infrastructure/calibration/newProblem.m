% NEWPROBLEM  What is asked of a case: limits, targets, benches, cost.
%
% CALL: PROBLEM = newProblem (CASE)
%       PROBLEM = newProblem (CASE, COST)
%
% CASE  struct of newCase; names, limits and targets are enough for tests
% COST  handle residual = cost (p, evaluateFunc): p d x 1, evaluateFunc
%       (p, varargin) -> T x 1 results; rows 1..T of residual belong to the
%       targets, further rows are preferences. One that takes more arguments
%       (costFunction) is handed the case as the third. Empty: the published
%       relative residual (result - target) / target
%
% PROBLEM, the same for calibration and diagnosis: names 1 x d cellstr, limits
% 2 x d, or 3 x d (toUnit), allowed (isAllowed; []: all sets of the box),
% paramMean, paramSd 1 x d (measured by themselves; NaN: not);
% of the targets, 1 x T: targetNames cellstr, value (NaN: not measured yet), sd,
% tol, trials, scatter, shared, correlation (see newTargets), held (logical: never
% fitted), calibrate (logical: measured and fitted), bench (number of the
% model), scale (what residual and tol are parts of: the value, 1 where they are
% absolute), curve (number of the measured curve, 0: none), series (number of
% the quantity along a coordinate, of results.csv or a curve; 0: none),
% seriesNames cellstr, coordinate (place on it, 0: none), part (what a residual
% is divided by in a sum of squares in which a curve counts once);
% benchNames, benchCost 1 x M; cost, standard (logical: the residuals are the
% published ones), nExtra (preference rows), options (see methodOptions below),
% coarse ([], or where CASE.coarse has levels a struct: variables 1 x v cellstr,
% levels L x v, the last row counts; column 1 x T, of each target's level, 0:
% none), fine (1 x v: values of these variables where runs count, the last
% level)
%
% Errors: DEcalioc:newProblem:badShape when cost gives fewer rows than targets,
% DEcalioc:newProblem:otherTargets when a row is not 0 where all results are
% the measured values: the cost function then aims at something else

function problem = newProblem (Case, cost)
  unknown = NaN (1, numel (Case.names));
  Case = mergeFields (struct ('paramMean', unknown, 'paramSd', unknown, ...
                              'options', struct (), 'coarse', []), Case);
  targets = arrayfun (@(t) mergeFields (oneTarget (), t), Case.targets, ...
                      'UniformOutput', false);
  targets = [targets{:}];
  problem = ofTargets (targets);
  for name = {'names', 'limits', 'paramMean', 'paramSd'}
    problem.(name{1}) = Case.(name{1});
  end
  problem.allowed = givenField (Case, 'allowed', []);
  info = targets;
  if isfield (Case, 'models')
    problem.benchNames = {Case.models.name};
    problem.benchCost = [Case.models.cost];
    info = targetInfo (Case);
  end
  problem = withSeries (problem, info);
  problem.part = problem.tol;
  for requirement = requirementsOf (problem)
    t = requirement{1};
    problem.part(t) = problem.tol(t) * sqrt (numel (t));
  end
  problem.options = mergeFields (methodOptions (), Case.options);
  problem.prior = similarPriors (Case);
  [problem.coarse, problem.fine] = levelsOf (Case.coarse, targets);
  if nargin < 2 || isempty (cost)
    value = problem.value(:);
    scale = problem.scale(:);
    cost = @(p, evaluateFunc) (evaluateFunc (p) - value) ./ scale;
  elseif abs (nargin (cost)) > 2
    cost = @(p, evaluateFunc) cost (p, evaluateFunc, Case);
  end
  problem.cost = cost;
  [problem.standard, problem.nExtra] = probeCost (problem);
end

% Where the case says nothing: of the user (docs/inputs.md), then of the method.
function o = methodOptions ()
  o = struct ('sets', 1, 'seed', 1, 'maxFunEvals', 40, 'maxIter', 3, ...
              'tolfun', 0.002, 'replicates', 1, 'WRL', 0, ...
              'method', 'robust', 'infill', 'thompson', ...
              'confidence', 0.95, 'intervals', false);
  % probability that ends the infill: runs that confirm bring the rest
  o.likely = 0.8;
  % below it as many runs at once confirm a set as can go
  o.unsure = 0.9;
  % from here on infill runs the found set alone, and preferences may choose
  o.even = 0.5;
  % a set less probable than this has turned out wrong
  o.wrong = 0.2;
  % likelier by this must another set be: two fits of the same runs differ less
  o.better = 0.02;
  % standard errors that contradict a tolerance or a surrogate: chance 0.3 %
  o.apart = 3;
  % rounds without a set that meets all before it is said: runs may show a way
  o.conflicts = 2;
  % of the sets that the intervals of the parameters are of, this share must fit
  o.fit = 0.8;
  % of the box: nearer to its wall a parameter stands at it; a wider interval
  % does not identify; how well a parameter measures by itself
  [o.atLimit, o.loose, o.direct] = deal (0.005, 0.5, 0.05);
  % runs for intervals on a curve (benchmarks/curveFewRuns.m), and runs a
  % parameter from which they are believed without (benchmarks/curveCoverage.m)
  [o.intervalRuns, o.curveRuns] = deal (6, 10);
  % of the plan that must succeed: else box or model is at fault
  o.planShare = 2 / 3;
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
                   'shared', 0, ...
                   'role', 'calibrate', 'model', 1, 'series', '', ...
                   'at', NaN, 'curve', 0, 'correlation', 0);
end

function problem = ofTargets (targets)
  for name = {'value', 'sd', 'tol', 'trials', 'curve', 'correlation', ...
              'shared'}
    problem.(name{1}) = double ([targets.(name{1})]);
  end
  problem.scatter = logical ([targets.scatter]);
  problem.bench = [targets.model];
  problem.scale = problem.value;
  problem.scale(logical ([targets.isAbsolute])) = 1;
  problem.held = strcmp ({targets.role}, 'holdout');
  problem.calibrate = strcmp ({targets.role}, 'calibrate');
  problem.targetNames = {targets.name};
  for t = find (cellfun (@isempty, problem.targetNames))
    problem.targetNames{t} = sprintf ('target_%d', t);
  end
end

% Quantities along a coordinate, those of different benches apart.
function problem = withSeries (problem, info)
  problem.seriesNames = {info.series};
  problem.coordinate = [info.at];
  isOn = ~cellfun (@isempty, problem.seriesNames) & ...
         ~isnan (problem.coordinate);
  labels = arrayfun (@(t, s) sprintf ('%d/%s', t, s{1}), problem.bench, ...
                     problem.seriesNames, 'UniformOutput', false);
  [~, ~, number] = unique (labels);
  problem.series = reshape (number, size (isOn)) .* isOn;
  problem.coordinate(isnan (problem.coordinate)) = 0;
end

function [standard, nExtra] = probeCost (problem)
  T = numel (problem.value);
  p = toAllowed (boxCentre (problem.limits), problem)';
  standard = true;
  isKnown = isfinite (problem.value(:));
  for factor = [0.7, 1.1]
    z = problem.value(:) + problem.scale(:) .* (factor.^(1:T)' - 1);
    r = problem.cost (p, @(varargin) z);
    if numel (r) < T
      error ('DEcalioc:newProblem:badShape', ...
             ['newProblem: the cost function must give one row a target ' ...
              '(%d), got %d.'], T, numel (r));
    end
    nExtra = numel (r) - T;
    published = (z - problem.value(:)) ./ problem.scale(:);
    gap = abs (abs (r(1:T)(:)) - abs (published));
    standard = standard && all (gap(isKnown) <= ...
                                1e-9 * abs (published(isKnown)));
  end
  met = problem.cost (p, @(varargin) problem.value(:));
  off = find (~(abs (met(1:T)(:)) <= 1e-6) & isKnown, 1);
  if ~isempty (off)
    error ('DEcalioc:newProblem:otherTargets', ...
           ['newProblem: row %d of costFunction must be 0 where every ' ...
            'result equals its target, got %g. Let it take the targets in ' ...
            'the order of optim.targetVal or measured.csv; costInput gives ' ...
            'them to costFunction.m.'], off, met(off));
  end
end

%!shared C
%! C.names = {'a', 'b'};
%! C.limits = [0, 0; 1, 2];
%! C.targets = struct ('value', {400, 0.03}, 'tol', 0.01, 'sd', 0, ...
%!                     'role', {'calibrate', 'holdout'});

%!test
%! p = newProblem (C, []);
%! assert (p.calibrate, [true, false]);
%! assert (p.held, [false, true]);
%! assert ({p.bench, p.series, p.targetNames}, ...
%!         {[1, 1], [0, 0], {'target_1', 'target_2'}});
%! assert (p.standard);
%! assert ([p.options.maxFunEvals, p.options.maxIter], [40, 3]);
%! C.options.maxIter = 7;
%! assert (newProblem (C).options.maxIter, 7);

%!test
%! % the published form, the other sign, a preference row
%! p = newProblem (C, @(p, f) [([400; 0.03] - f (p)) ./ [400; 0.03]; p(1)]);
%! assert (p.standard);
%! assert (p.nExtra, 1);

%!test
%! p = newProblem (C, @(p, f) f (p) - [400; 0.03]);
%! assert (~ p.standard);

%!test
%! % a target of 0 with an absolute tolerance, one that is not measured yet, a
%! % curve of two points
%! D = C;
%! D.targets = struct ('name', {'a', 'b', 'w@1', 'w@2'}, ...
%!                     'value', {0, NaN, 2, 4}, 'tol', 0.1, ...
%!                     'isAbsolute', {true, false, false, false}, ...
%!                     'curve', {0, 0, 1, 1}, ...
%!                     'series', {'', '', 'w', 'w'}, ...
%!                     'role', {'calibrate', 'unmeasured', 'calibrate', ...
%!                              'calibrate'}, ...
%!                     'at', {NaN, NaN, 1, 2});
%! p = newProblem (D, []);
%! assert ([p.series > 0; p.coordinate], [0, 0, 1, 1; 0, 0, 1, 2]);
%! assert (p.standard);
%! assert (p.calibrate, [true, false, true, true]);
%! assert (p.part([1, 3, 4]), 0.1 * [1, sqrt(2), sqrt(2)], 1e-12);
%! assert (targetResidual (p, [0.5, 1], [0.3, 7, 3, 3]), ...
%!         [0.3, NaN, 0.5, -0.25], 1e-12);

%!error id=DEcalioc:newProblem:badShape newProblem (C, @(p, f) 1);
%!error id=DEcalioc:newProblem:otherTargets
%! newProblem (C, @(p, f) f (p) ./ [0.03; 400] - 1);
