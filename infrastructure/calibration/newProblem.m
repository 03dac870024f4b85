% NEWPROBLEM  What the statistics need of a case: limits, targets, cost.
%
% CALL: problem = newProblem (Case, cost)
%
% Case  struct of newCase (fields names, limits, targets, options are used)
% cost  handle residual = cost (p, evaluateFunc): p d x 1, evaluateFunc
%       (p, varargin) -> T x 1 results; rows 1..T of residual belong to the
%       targets, further rows are preferences. One that takes more arguments
%       (costFunction) is handed the case as the third. Empty: the published
%       relative residual (result - target) / target
%
% problem: names 1 x d cellstr, limits 2 x d, targets 1 x T struct, value, tol,
% sd 1 x T, paramMean, paramSd 1 x d (measured by themselves; NaN: not),
% calibrate 1 x T logical (false: held out, never used in a fit),
% cost, standard (logical: the residuals are the published ones), nExtra
% (preference rows), options with all defaults:
%   sets 1, seed 1, maxFunEvals 40, maxIter 3, tolfun 0.002, replicates 4,
%   WRL 0, method 'robust', confidence 0.95
% newSets (handle, parameter sets that may still be run: Inf, see withinBudget)
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
  [problem.paramMean, problem.paramSd] = deal (NaN (1, numel (Case.names)));
  if isfield (Case, 'paramMean')
    problem.paramMean = Case.paramMean;
    problem.paramSd = Case.paramSd;
  end
  problem.calibrate = true (1, numel (targets));
  if isfield (targets, 'role')
    problem.calibrate = ~strcmp ({targets.role}, 'holdout');
  end
  problem.options = withDefaults (Case);
  problem.newSets = @() Inf;
  if nargin < 2 || isempty (cost)
    value = problem.value(:);
    cost = @(p, evaluateFunc) (evaluateFunc (p) - value) ./ value;
  elseif abs (nargin (cost)) > 2
    cost = @(p, evaluateFunc) cost (p, evaluateFunc, Case);
  end
  problem.cost = cost;
  [problem.standard, problem.nExtra] = probeCost (problem);
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
                    'maxIter', 3, 'tolfun', 0.002, 'replicates', 4, ...
                    'WRL', 0, 'method', 'robust', 'confidence', 0.95);
  if isfield (Case, 'options')
    options = mergeFields (options, Case.options);
  end
end

function [standard, nExtra] = probeCost (problem)
  T = numel (problem.value);
  p = mean (problem.limits, 1)';
  standard = true;
  for factor = [0.7, 1.1]
    z = problem.value(:) .* factor.^(1:T)';
    r = problem.cost (p, @(varargin) z);
    if numel (r) < T
      error ('DEcalioc:newProblem:badShape', ...
             ['newProblem: the cost function must give one row a target ' ...
              '(%d), got %d.'], T, numel (r));
    end
    nExtra = numel (r) - T;
    published = (z - problem.value(:)) ./ problem.value(:);
    gap = abs (abs (r(1:T)(:)) - abs (published));
    standard = standard && all (gap <= 1e-9 * abs (published));
  end
  met = problem.cost (p, @(varargin) problem.value(:));
  off = find (~(abs (met(1:T)) <= 1e-6), 1);
  if ~isempty (off)
    error ('DEcalioc:newProblem:otherTargets', ...
           ['newProblem: row %d of costFunction must be 0 where every ' ...
            'result equals its target, got %g. Let it take the targets in ' ...
            'the order of optim.targetVal, model by model.'], off, met(off));
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

%!error id=DEcalioc:newProblem:badShape newProblem (C, @(p, f) 1);
%!error id=DEcalioc:newProblem:otherTargets
%! newProblem (C, @(p, f) f (p) ./ [0.03; 400] - 1);
