% NEWPROBLEM  What is asked of a case: limits, targets, benches, cost.
%
% CALL: PROBLEM = newProblem (CASE)
%       PROBLEM = newProblem (CASE, COST)
%
% CASE  struct of newCase (tests: names, limits and targets are enough)
% COST  handle residual = cost (p, evaluateFunc): p d x 1, evaluateFunc
%       (p, varargin) -> T x 1 results; rows 1..T of residual belong to the
%       targets, further rows are preferences. One that takes more arguments
%       (costFunction) is handed the case as the third. Empty: the published
%       relative residual (result - target) / target
%
% PROBLEM, the same for calibration and diagnosis: names 1 x d cellstr, limits
% 2 x d, paramMean, paramSd 1 x d (measured by themselves; NaN: not);
% of the targets, 1 x T: targetNames cellstr, value (NaN: not measured yet), sd,
% tol, trials, scatter, correlation (see docs/data.md), held (logical: never
% fitted), calibrate (logical: measured and fitted), bench (number of the
% model), scale (what residual and tol are parts of: the value, 1 where they are
% absolute), curve (number of the measured curve, 0: none), series (number of
% the quantity along a coordinate, of results.csv or a curve; 0: none),
% seriesNames cellstr, coordinate (place on it, 0: none), part (what a residual
% is divided by in a sum of squares in which a curve counts once);
% benchNames, benchCost 1 x M; cost, standard (logical: the residuals are the
% published ones), nExtra (preference rows), options of calibrationOptions,
% coarse ([], or where CASE.coarse has levels a struct: variables 1 x v cellstr,
% levels L x v, the last row counts; column 1 x T, of each target's level, 0:
% none), fine (1 x v: values of these variables where runs count, the last
% level)
%
% Errors: DEcalioc:newProblem:badShape when cost gives fewer rows than targets,
% DEcalioc:newProblem:otherTargets when a row is not 0 where all results are
% the measured values: the cost function then aims at something else

function problem = newProblem (Case, cost)
  problem = ofTargets (Case.targets);
  problem.names = Case.names;
  problem.limits = Case.limits;
  [problem.paramMean, problem.paramSd] = deal (NaN (1, numel (Case.names)));
  if isfield (Case, 'paramMean')
    problem.paramMean = Case.paramMean;
    problem.paramSd = Case.paramSd;
  end
  if isfield (Case, 'models')
    problem.benchNames = {Case.models.name};
    problem.benchCost = [Case.models.cost];
    problem = withSeries (problem, targetInfo (Case));
  end
  problem.part = problem.tol;
  for requirement = requirementsOf (problem)
    t = requirement{1};
    problem.part(t) = problem.tol(t) * sqrt (numel (t));
  end
  problem.options = calibrationOptions (givenField (Case, 'options', []));
  problem.prior = similarPriors (Case);
  problem.coarse = coarseOf (Case);
  problem.fine = zeros (1, 0);
  if ~isempty (problem.coarse)
    problem.fine = problem.coarse.levels(end, :);
  end
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

function coarse = coarseOf (Case)
  coarse = [];
  if ~isfield (Case, 'coarse') || isempty (Case.coarse)
    return
  end
  coarse.variables = {Case.coarse.variable};
  coarse.levels = vertcat (Case.coarse.levels)';
  coarse.column = zeros (1, numel (Case.targets));
  for k = 1:numel (Case.coarse)
    isOfModel = ismember ([Case.targets.model], Case.coarse(k).models);
    coarse.column(isOfModel) = k;
  end
end

function problem = ofTargets (targets)
  T = numel (targets);
  numbers = {'value', NaN; 'sd', 0; 'tol', 0.01; 'trials', 1; ...
             'scatter', false; 'curve', 0; 'correlation', 0}';
  for field = numbers
    problem.(field{1}) = fieldRow (targets, field{:});
  end
  problem.scatter = logical (problem.scatter);
  problem.bench = fieldRow (targets, 'model', 1);
  problem.scale = problem.value;
  problem.scale(fieldRow (targets, 'isAbsolute', 0) > 0) = 1;
  problem.held = false (1, T);
  problem.calibrate = true (1, T);
  if isfield (targets, 'role')
    problem.held = strcmp ({targets.role}, 'holdout');
    problem.calibrate = strcmp ({targets.role}, 'calibrate');
  end
  problem.targetNames = arrayfun (@(t) sprintf ('target_%d', t), 1:T, ...
                                  'UniformOutput', false);
  if isfield (targets, 'name')
    problem.targetNames = {targets.name};
  end
  problem.seriesNames = repmat ({''}, 1, T);
  if isfield (targets, 'series')
    problem.seriesNames = {targets.series};
  end
  coordinate = num2cell (fieldRow (targets, 'at', NaN));
  problem = withSeries (problem, struct ('series', problem.seriesNames, ...
                                         'at', coordinate));
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

function row = fieldRow (targets, name, default)
  row = default * ones (1, numel (targets));
  if isfield (targets, name)
    row = double ([targets.(name)]);
  end
end

function [standard, nExtra] = probeCost (problem)
  T = numel (problem.value);
  p = mean (problem.limits, 1)';
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
%! assert (p.options.maxFunEvals, 40);

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
