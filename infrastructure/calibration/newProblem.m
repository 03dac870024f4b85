% NEWPROBLEM  What the statistics need of a case: limits, targets, cost.
%
% CALL: PROBLEM = newProblem (CASE, COST)
%
% CASE  struct of newCase (fields names, limits, targets, options are used)
% COST  handle residual = cost (p, evaluateFunc): p d x 1, evaluateFunc
%       (p, varargin) -> T x 1 results; rows 1..T of residual belong to the
%       targets, further rows are preferences. One that takes more arguments
%       (costFunction) is handed the case as the third. Empty: the published
%       relative residual (result - target) / target
%
% PROBLEM: names 1 x d cellstr, limits 2 x d, targets 1 x T struct, value (NaN:
% not measured yet), tol, sd 1 x T, paramMean, paramSd 1 x d (measured by
% themselves; NaN: not), scale 1 x T (what residual and tol are parts of: the
% value, 1 where they are absolute), trials, scatter 1 x T (see docs/data.md),
% curve, at, correlation 1 x T (number of the curve, 0: none; place on it;
% length over which errors are alike), part 1 x T (what a residual is divided by
% in a sum of squares in which a curve counts once),
% calibrate 1 x T logical (false: held out or not measured, never fitted),
% cost, standard (logical: the residuals are the published ones), nExtra
% (preference rows), options with all defaults:
%   sets 1, seed 1, maxFunEvals 40, maxIter 3, tolfun 0.002, replicates 1,
%   WRL 0, method 'robust', confidence 0.95
% newSets (handle, parameter sets that may still be run: Inf, see withinBudget),
% coarse ([], or where CASE.coarse has levels a struct: variables 1 x v cellstr,
% levels L x v, the last row counts; column 1 x T, of each target's level, 0:
% none), levelSeconds (handle, 1 x L: what a run costs, [] where
% nothing is known; see withinBudget)
%
% Errors: DEcalioc:newProblem:badShape when cost gives fewer rows than targets,
% DEcalioc:newProblem:otherTargets when a row is not 0 where all results are
% the measured values: the cost function then aims at something else
%
% See also: targetResidual, calibrateOnKriging

function problem = newProblem (Case, cost)
  targets = Case.targets;
  problem.names = Case.names;
  problem.limits = Case.limits;
  problem.targets = targets;
  problem.value = fieldRow (targets, 'value', NaN);
  problem.tol = fieldRow (targets, 'tol', 0.01);
  problem.sd = fieldRow (targets, 'sd', 0);
  problem.scale = problem.value;
  problem.scale(fieldRow (targets, 'isAbsolute', 0) > 0) = 1;
  problem.trials = fieldRow (targets, 'trials', 1);
  problem.scatter = logical (fieldRow (targets, 'scatter', false));
  problem.curve = fieldRow (targets, 'curve', 0);
  problem.at = fieldRow (targets, 'at', NaN);
  problem.correlation = fieldRow (targets, 'correlation', 0);
  [problem.paramMean, problem.paramSd] = deal (NaN (1, numel (Case.names)));
  if isfield (Case, 'paramMean')
    problem.paramMean = Case.paramMean;
    problem.paramSd = Case.paramSd;
  end
  problem.calibrate = true (1, numel (targets));
  if isfield (targets, 'role')
    problem.calibrate = strcmp ({targets.role}, 'calibrate');
  end
  problem.part = problem.tol;
  for own = requirementsOf (problem)
    problem.part(own{1}) = problem.tol(own{1}) * sqrt (numel (own{1}));
  end
  problem.options = withDefaults (Case);
  problem.newSets = @() Inf;
  problem.coarse = coarseOf (Case);
  problem.levelSeconds = @() [];
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
    own = ismember ([Case.targets.model], Case.coarse(k).models);
    coarse.column(own) = k;
  end
end

function row = fieldRow (targets, name, default)
  row = default * ones (1, numel (targets));
  if isfield (targets, name)
    for t = 1:numel (targets)
      row(t) = targets(t).(name);
    end
  end
end

function options = withDefaults (Case)
  options = struct ('sets', 1, 'seed', 1, 'maxFunEvals', 40, ...
                    'maxIter', 3, 'tolfun', 0.002, 'replicates', 1, ...
                    'WRL', 0, 'method', 'robust', 'confidence', 0.95);
  if isfield (Case, 'options')
    options = mergeFields (options, Case.options);
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
%!                              'calibrate'});
%! p = newProblem (D, []);
%! assert (p.standard);
%! assert (p.calibrate, [true, false, true, true]);
%! assert (p.part([1, 3, 4]), 0.1 * [1, sqrt(2), sqrt(2)], 1e-12);
%! assert (targetResidual (p, [0.5, 1], [0.3, 7, 3, 3]), ...
%!         [0.3, NaN, 0.5, -0.25], 1e-12);

%!error id=DEcalioc:newProblem:badShape newProblem (C, @(p, f) 1);
%!error id=DEcalioc:newProblem:otherTargets
%! newProblem (C, @(p, f) f (p) ./ [0.03; 400] - 1);
