% NEWPROBLEM  What is asked: limits, targets, benches, effects, cost.
%
% CALL: PROBLEM = newProblem (CASE)
%       PROBLEM = newProblem (CASE, COST)
%       [PROBLEM, NOTES] = newProblem (CASE, [], C)   of a change
%       PROBLEM = newProblem (GIVEN)                  of matrices
%
%   CASE   struct of newCase; names, limits and targets are enough for tests
%   COST   handle residual = cost (p, evaluateFunc): p d x 1, evaluateFunc
%          (p, varargin) -> T x 1 results; rows 1..T of residual belong to the
%          targets, further rows are preferences. One that takes more arguments
%          (costFunction) is handed the case as the third. Empty: the published
%          relative residual (result - target) / target
%   C      number of a condition of CASE: its values are the measured ones then,
%          those of CASE.targets the reference; without conditions no matter
%   GIVEN  struct with some of the fields below; value, sd, limits and bench are
%          needed, a problem of newProblem is one
%   NOTES  cellstr, what had to be assumed
%
% PROBLEM, the same for calibration and diagnosis (default where GIVEN has none):
%   of the box
%     names (p1 ...)  1 x p cellstr;  limits  2 x p, or 3 x p (toUnit)
%     paramMean, paramSd  1 x p, values measured by themselves (NaN: none)
%     paramPrior  struct mean, sd: these in [-1, 1]; sd Inf: uniform
%     allowed  see isAllowed ([]: all sets of the box)
%     centre   1 x p, the middle of the box, or the allowed set near it
%   of the targets, 1 x T
%     targetNames (t1 ...), value (NaN: not measured yet)
%     sd        standard uncertainty of value: the stated one, or a first guess
%     sdKnown   logical, false: sd is a guess of a noise of unknown size (true);
%               of a case it is half of the tolerance
%     statedSd  sd, 0 where it is a guess: what a calibration counts with
%     held      logical, kept out of every fit (none)
%     calibrate logical, measured and fitted
%     aside     logical, of a change not used: the model cannot follow it, see setAside
%               (none)
%     tol (0.01), scale (value): what residual and tol are parts of, 1 where
%               they are absolute; part (tol), what a residual is divided by in
%               a sum of squares in which a curve counts once
%     trials    how many trials value is the mean of: the real material has a
%               packing of its own too, Inf if sd holds that scatter (1)
%     scatter   logical, sd was found from the scatter of the trials and holds
%               their packings: the larger of the two counts (false)
%     shared    the part of sd that a whole series shares, as its values are of
%               the same sessions (0)
%     freedom, commonFreedom, sessionFreedom   by which sd is known, which is the
%               68 % half-width, see varianceComponents (Inf)
%     swept     logical, its change was read only before or only after the
%               reference, while values drifted (false)
%     noiseSd   known noise of one run (NaN: from data)
%     earlierSd, earlierRuns  scatter of a run over so many earlier packings, what
%               a calibration begins with (NaN, 0); of a case see earlierScatter
%     curve     targets with one number > 0 are measured together (0)
%     series, coordinate, seriesNames  targets with one number > 0 are the same
%               quantity along a coordinate: speed, time, opening ... (0, 0, '')
%     correlation  length over which errors of a series are alike, see
%               newTargets (0);  estimateSeries  logical, it is estimated (false)
%     covariance  T x T of the measurement, instead of sd ([])
%     reading   cellstr, what one rule reads off ('': nobody says it)
%     used, heldOut, possible  numbers of targets;  kept, unit: see enterRuns
%   of the benches
%     bench  1 x T, number of the bench of each target
%     benchNames (bench1 ...), benchCost (1)  1 x B, of one measurement
%   of what may be missing
%     effects   1 x K struct, see newEffect ([]);  causes  of listCauses ([])
%     reference struct, the same measured where every effect is neutral: value,
%               sd, trials, scatter, shared and the freedoms (1 x T; NaN:
%               not measured there), together (T x T, covariance with what was
%               measured now, as both are of the same sessions) and perCondition
%               (1 x p logical, parameters that are other ones there); the
%               diagnosis is one of the change then ([])
%   form      what is known of the responses beforehand, see fitSurrogates; no
%             case has it (benchmarks do)
%   of a case also: cost, standard (logical: the residuals are the published
%     ones), nExtra (preference rows), options (methodOptions), prior
%     and shape ({}) and others (what is known before is for the caller to add, see
%     withEarlier),
%     coarse ([], or where CASE.coarse has levels a struct: variables 1 x v cellstr,
%     levels L x v, the last row counts; column 1 x T, of each target's level,
%     0: none), fine (1 x v: values of these variables
%     where runs count, the last level)
%
% Errors: DEcalioc:newProblem:badShape when cost gives fewer rows than targets,
% DEcalioc:newProblem:otherTargets when a row is not 0 where all results are
% the measured values: the cost function then aims at something else; of GIVEN
% those of checkProblem
%
% See also: diagnoseMatrices, newEffect, problemFields

function [problem, notes] = newProblem (source, cost, c)
  notes = {};
  if ~isfield (source, 'targets')
    problem = filled (source);
    checkProblem (problem);
    problem = derived (problem);
    return
  end
  Case = mergeFields (struct ('options', struct ()), source);
  given = targetsOfCase (Case);
  for name = {'names', 'limits', 'paramMean', 'paramSd', 'allowed'}
    if isfield (Case, name{1})
      given.(name{1}) = Case.(name{1});
    end
  end
  given.options = mergeFields (methodOptions (), Case.options);
  given.prior = {};
  if ~strcmp (given.options.method, 'published')
    [given.earlierSd, given.earlierRuns] = earlierScatter (Case);
  end
  given = filled (given);
  for requirement = requirementsOf (given)
    t = requirement{1};
    given.part(t) = given.tol(t) * sqrt (numel (t));
  end
  notes = guessNote (given);
  if nargin > 2 && ~isempty (givenField (Case, 'conditions', {}))
    given = withCondition (given, Case, c);
  end
  [given, lost] = withCorrelation (given);
  notes = [notes, lost];
  given = effectsOfCase (given, Case);
  problem = derived (filled (given));
  if nargin < 2
    cost = [];
  end
  problem = withCost (problem, cost, Case);
end

function note = guessNote (given)
  note = {};
  bare = find (~given.sdKnown & isfinite (given.value));
  if ~isempty (bare)
    [~, names] = requirementsOf (given, bare);
    note = {sprintf(['no measurement uncertainty given for %s: its size ' ...
                     'is estimated, starting from half of the tolerance ' ...
                     '(sd of measured.csv, or optim.targetStd)'], ...
                    strjoin (unique (names, 'stable'), ', '))};
  end
end

% Every field that is missing gets its default; rows are rows.
function problem = filled (given)
  for needed = {'value', 'sd', 'limits', 'bench'}
    if ~isfield (given, needed{1})
      error ('DEcalioc:newProblem:missingField', ...
             'newProblem: GIVEN must have the field %s.', needed{1});
    end
  end
  problem = mergeFields (struct ('allowed', [], 'covariance', [], ...
                                 'effects', [], 'causes', [], ...
                                 'reference', []), asRows (given));
  [T, p] = deal (numel (given.value), columns (given.limits));
  n = struct ('T', T, 'p', p, 'B', max (given.bench));
  for field = problemFields ()
    if ~isfield (problem, field.name)
      problem.(field.name) = repeated (field.default, n.(field.count));
    elseif islogical (field.default)
      problem.(field.name) = logical (problem.(field.name));
    end
  end
  if ~isfield (given, 'scale')
    problem.scale = problem.value;
  end
  if ~isfield (given, 'calibrate')
    problem.calibrate = isfinite (problem.value) & ~problem.held;
  end
  if ~isempty (problem.reference)
    row = ones (1, T);
    problem.reference = mergeFields (struct ('trials', row, 'scatter', row < 0, ...
                                             'shared', 0 * row, 'freedom', ...
                                             Inf * row, 'commonFreedom', ...
                                             Inf * row, 'sessionFreedom', ...
                                             Inf * row, 'together', zeros (T), ...
                                             'perCondition', false (1, p)), ...
                                     problem.reference);
  end
  if isscalar (problem.trials)
    problem.trials = repmat (problem.trials, 1, T);
  end
  problem.limits = reshape (problem.limits, [], p);
  problem.effects = arrayfun (@(e) newEffect (e, T), problem.effects(:)');
end

function given = asRows (given)
  for name = fieldnames (given)'
    value = given.(name{1});
    if (isnumeric (value) || islogical (value) || iscell (value)) && ...
       isvector (value)
      given.(name{1}) = reshape (value, 1, []);
    end
  end
end

function values = repeated (default, n)
  if ischar (default)
    values = arrayfun (@(k) sprintf ('%s%d', default, k), 1:n, ...
                       'UniformOutput', false);
  else
    values = repmat (default, 1, n);
  end
end

% What follows from the other fields, anew each time: they may have changed.
function problem = derived (problem)
  isThere = isfinite (problem.value);
  problem.used = find (isThere & ~problem.held & ~problem.aside);
  problem.heldOut = find (isThere & problem.held);
  problem.possible = find (~isThere);
  problem.statedSd = problem.sd .* problem.sdKnown;
  problem.kept = 1:numel (problem.value);
  problem.unit = ones (size (problem.value));
  problem.centre = toAllowed (boxCentre (problem.limits), problem);
  prior.mean = 2 * toUnit (problem.paramMean, problem.limits) - 1;
  prior.sd = 2 * problem.paramSd ./ boxWidth (problem.limits, problem.paramMean);
  without = ~isfinite (prior.mean) | ~isfinite (prior.sd);
  prior.mean(without) = 0;
  prior.sd(without) = Inf;
  problem.paramPrior = prior;
end

function problem = withCost (problem, cost, Case)
  if isempty (cost)
    value = problem.value(:);
    scale = problem.scale(:);
    cost = @(p, evaluateFunc) (evaluateFunc (p) - value) ./ scale;
  elseif abs (nargin (cost)) > 2
    cost = @(p, evaluateFunc) cost (p, evaluateFunc, Case);
  end
  problem.cost = cost;
  [problem.standard, problem.nExtra] = probeCost (problem);
end

function [standard, nExtra] = probeCost (problem)
  T = numel (problem.value);
  p = problem.centre';
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

% How much of a parameter one width of the box is: derivative of the parameter by its place in
% the unit box. In logarithms the width grows with the parameter.
function w = boxWidth (limits, P)
  w = limits(2, :) - limits(1, :);
  isLog = any (limits(3:end, :), 1);
  if any (isLog)
    w = repmat (w, rows (P), 1);
    w(:, isLog) = P(:, isLog) .* log (limits(2, isLog) ./ limits(1, isLog));
  end
end

% The options of a calibration where its case says nothing: those of the user
% (docs/inputs.md), then those of the method, each with its reason.
function o = methodOptions ()
  o = struct ('sets', 1, 'seed', 1, 'maxFunEvals', 40, 'maxIter', 3, ...
              'tolfun', 0.002, 'replicates', 1, 'WRL', 0, ...
              'method', 'robust', 'infill', 'ahead', ...
              'confidence', 0.95, 'intervals', false);
  % probability that ends the infill: runs that confirm bring the rest
  o.likely = 0.8;
  % so sure should runs at a set make one, and so many are thought ahead for it:
  % with one alone no new set is worth it (infillAhead)
  [o.aimed, o.ahead] = deal (0.9, [1, 2, 4, 8, 16]);
  % below it as many runs at once confirm a set as can go
  o.unsure = 0.9;
  % from here on preferences may choose
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
  % runs for intervals on a curve (closed study curveFewRuns.m), and runs a
  % parameter from which they are believed without (closed study curveCoverage.m)
  [o.intervalRuns, o.jointRuns] = deal (6, 10);
  % of the plan that must succeed: else box or model is at fault
  o.planShare = 2 / 3;
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
%!test
%! % errors along a series of results.csv
%! Case.targets = struct ('value', 1, 'sd', {1, 2, 2}, 'tol', 0.1, ...
%!                        'name', {'a', 'b', 'c'}, 'role', 'calibrate', ...
%!                        'model', 1, 'index', {1, 2, 3}, 'trials', 1, ...
%!                        'correlation', 5);
%! folder = emptyFolder ();
%! Case.models = struct ('name', 'A', 'folder', folder, 'cost', 1);
%! writeAtomic (fullfile (folder, 'results.csv'), ...
%!              ["name,kind,unit,series,at,text\na,rate,kg/s,w,10,x\n", ...
%!               "b,rate,kg/s,w,15,x\nc,mass,kg,,,x\n"]);
%! [Case.names, Case.limits] = deal ({'mu'}, [0; 1]);
%! [Case.paramMean, Case.paramSd] = deal (NaN);
%! Case.effects = [];
%! given = newProblem (Case);
%! assert (given.covariance, [1, 2 / e, 0; 2 / e, 4, 0; 0, 0, 4], 1e-5);
%! assert (given.estimateSeries, false (1, 3));
%! % to be estimated: no covariance yet
%! [Case.targets.correlation] = deal (NaN);
%! [given, notes] = newProblem (Case);
%! assert (isempty (given.covariance) && isempty (notes));
%! assert (given.estimateSeries, [true, true, false]);
%! % a neighbour that is not measured, or held out, tells no length
%! Case.targets(2).value = NaN;
%! [given, notes] = newProblem (Case);
%! assert (given.estimateSeries, false (1, 3));
%! assert (! isempty (regexp (notes{1}, 'optim.correlation .* of A$')));
%! [Case.targets(2).value, Case.targets(2).role] = deal (1, 'holdout');
%! assert (newProblem (Case).estimateSeries, false (1, 3));
%! % of a change: its condition, with the sd of the reference where it has none
%! [Case.perCondition, Case.conditions] = deal (true, {'moist'});
%! [Case.targets.changed] = deal (struct ('value', 7, 'sd', 0, 'trials', 3, ...
%!                                        'scatter', true));
%! given = newProblem (Case, [], 1);
%! assert ([given.value; given.sd; given.trials; given.scatter], ...
%!         [7, 7, 7; 1, 2, 2; 3, 3, 3; 1, 1, 1]);
%! assert ({given.reference.value, given.reference.condition}, ...
%!         {[1, 1, 1], 'moist'});
%!test
%! % of matrices, as of a case: the same fields
%! given = struct ('value', [1, 2, NaN], 'sd', [1, 1, 1], 'limits', [0; 1], ...
%!                 'bench', [1, 1, 2]);
%! problem = newProblem (given);
%! assert (problem.used, [1, 2]);
%! assert (problem.possible, 3);
%! assert (problem.benchNames, {'bench1', 'bench2'});
%! assert (problem.trials, [1, 1, 1]);
%! assert (problem.sdKnown, true (1, 3));
%! given.trials = 4;
%! assert (newProblem (given).trials, [4, 4, 4]);
%! given.trials = [1; 2; Inf];
%! assert (newProblem (given).trials, [1, 2, Inf]);
%! given.held = [false, true, false];
%! problem = newProblem (given);
%! assert (problem.used, 1);
%! assert (problem.heldOut, 2);
%! given.limits = [0, 2; 1, 6];
%! [given.paramMean, given.paramSd] = deal ([0.75, NaN], [0.1, NaN]);
%! assert (newProblem (given).paramPrior, ...
%!         struct ('mean', [0.5, 0], 'sd', [0.2, Inf]), 1e-12);
%! % in logarithms the width of the box grows with the parameter
%! given.limits = [1, 0; 100, 2; 1, 0];
%! X = fromUnit ([0.3; 0.3 + 1e-6] * [1, 1], given.limits);
%! [given.paramMean, given.paramSd] = deal (X(1, :), [0.1, 0.1]);
%! assert (newProblem (given).paramPrior.sd, 0.2 ./ diff (X) * 1e-6, -1e-4);

% SPDX-License-Identifier: GPL-3.0-only
