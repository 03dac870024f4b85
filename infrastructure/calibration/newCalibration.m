% NEWCALIBRATION  Sums a finished calibration up.
%
% CALL: C = newCalibration (STATE, PROBLEM, CASE)
%
%   STATE  see newState, with its field final
%   C      scalar struct: params, residual, noiseSd, converged, ending,
%          reason, limit,
%          conflict, met, state, estimate, outcomes, probability, results,
%          resultSd (standard error of the mean), resultInterval90 (of
%          the set, see confirmSet), runs (there), untested (calibrateOnDEM);
%          interval90 2 x d, correlation d x d, posterior (n x d, sample),
%          intervalNote, intervalCode (note and code of knownParameters),
%          notIdentified (cellstr of parameters whose interval is
%          wider than options.loose of the box), sources (struct: own, imported,
%          otherCases, parameter sets of which origin the data hold, misled, see
%          keepApart), form (struct: known, believed, results of which form.csv knows
%          the shape, and those whose runs agree), identifiability (weakness
%          below), sensitivity d x T (total Sobol indices); demRuns,
%          coreSeconds, atLimit, warnings, levels (describeLevels below),
%          surrogates, history, data, exitStatus; holdout (1 x h: name, model, target,
%          result (prediction of the mean response), sd (of the prediction
%          error), interval90 2 x 1 (where a measurement should lie), inside
%          (logical; NaN: not measured yet), leftOpen (logical: only other parameter
%          values that the targets allow bring it inside); []: none)

function c = newCalibration (state, problem, Case)
  final = state.final;
  known = knownParameters (state, problem);
  M = numel (Case.models);
  count = @(varargin) M * sum (ismember (state.data.stage, varargin));
  c = struct ('results', final.result, 'resultInterval90', final.interval90, ...
              'resultSd', final.sd, 'runs', final.n, 'interval90', known.interval90, ...
              'posterior', known.sample, 'correlation', known.correlation);
  [c.intervalNote, c.intervalCode] = deal (known.note, known.code);
  for name = {'params', 'residual', 'noiseSd', 'converged', 'ending', ...
              'reason', 'limit', 'conflict', 'met', 'state', 'estimate', ...
              'outcomes', 'untested', ...
              'probability'}
    c.(name{1}) = final.(name{1});
  end
  c.demRuns = struct ('plan', count ('plan'), 'infill', count ('infill'), ...
                      'verify', count ('verify', 'replicate', 'repeat'), ...
                      'failed', state.budget.failed, ...
                      'reused', state.budget.reused);
  isOther = ismember (state.data.stage, {'import', 'library'});
  of = @(stage) sum (strcmp (state.data.stage, stage));
  c.sources = struct ('own', sum (~isOther), 'imported', of ('import'), ...
                      'otherCases', of ('library'), 'misled', state.misled);
  hasShape = ~cellfun (@isempty, givenField (problem, 'shape', {}));
  isShape = ~cellfun (@ischar, {state.surrogates.trend});
  c.form = struct ('known', sum (hasShape), 'believed', sum (isShape));
  c.coreSeconds = state.budget.coreSeconds;
  [c.warnings, c.atLimit] = checkSurrogates (state, problem, known.interval90);
  c.sensitivity = totalIndices (state.surrogates, problem);
  c.identifiability = weakness (state.surrogates, problem, known, c.sensitivity);
  if strcmp (known.code, 'no fit')       % nor is anything else said of them
    c.posterior = known.sample([], :);
    c.correlation = full (eye (columns (known.sample)));
    c.identifiability.text = {};
    c.identifiability.directions = zeros (columns (known.sample), 0);
    c.identifiability.next = c.identifiability.next([]);
  end
  c.notIdentified = c.identifiability.notIdentified;
  c.holdout = predictHoldout (state, problem, known);
  c.levels = describeLevels (state, problem);
  for name = {'surrogates', 'history', 'data'}
    c.(name{1}) = state.(name{1});
  end
  c.exitStatus = 2 * ~final.converged;
end

% What the targets cannot fix, and what would fix it: notIdentified, directions
% d x k (unit vectors in the unit box along which the posterior keeps more than
% options.loose of the prior's standard deviation), text (cellstr, these in
% words), next (struct array, best first: code 'fit' (a held-out target),
% 'measure' (a target that is not measured yet) or 'direct' (the parameter
% itself), kind (the code in words), name, gain (share of the total relative
% variance of the parameters that it should take away)). A parameter that drives less
% than a twentieth of each target is no advice: the model may not read it at all. Nor
% is any other, where all that are open are such.
function weak = weakness (surrogates, problem, known, sensitivity)
  U = toUnit (known.sample, problem.limits);
  weak.notIdentified = problem.names(~known.identified);
  [V, D] = eig (cov (U));
  loose = sqrt (diag (D)) > problem.options.loose / sqrt (12);
  weak.directions = fliplr (V(:, loose));
  weak.text = cellfun (@(v) inWords (v, problem.names), ...
                       num2cell (weak.directions, 1), 'UniformOutput', false);
  kinds = struct ('fit', 'held-out target', 'measure', 'measure', ...
                  'direct', 'measure directly');
  entry = @(code, name, gain) struct ('code', code, 'kind', kinds.(code), ...
                                      'name', name, 'gain', gain);
  next = repmat (entry ('fit', '', 0), 1, 0);
  for t = find (~problem.calibrate)
    [m, v] = predictSurrogate (surrogates(t), known.sample);
    s2 = mean (v) + surrogates(t).noiseVar + problem.statedSd(t)^2;
    code = merge (isnan (problem.value(t)), 'measure', 'fit');
    next(end + 1) = entry (code, surrogates(t).name, gainOf (U, m, s2));
  end
  s2 = problem.options.direct^2;
  isAlive = max ([sensitivity(:, problem.calibrate), zeros(columns (U), 1)], [], 2)' >= 0.05;
  isOpen = ~known.identified;
  for j = find (isAlive & (any (isAlive & isOpen) | ~any (isOpen)))
    next(end + 1) = entry ('direct', problem.names{j}, gainOf (U, U(:, j), s2));
  end
  [~, order] = sort ([next.gain], 'descend');
  weak.next = next(order);
end

% 'a', or 'more a with less b'.
function text = inWords (v, names)
  v = v / max (abs (v));
  [~, order] = sort (abs (v), 'descend');
  order = order(abs (v(order)) > 0.3)(:)';
  v = v * sign (v(order(1)));
  parts = arrayfun (@(j) [merge(v(j) < 0, 'less ', 'more '), names{j}], order, ...
                    'UniformOutput', false);
  text = names{order(1)};
  if ~isscalar (order)
    text = strjoin (parts, ' with ');
  end
end

% Linear Bayes: measuring y with variance s2 takes cov (p, y)^2 / (var (y) + s2)
% off the variance of p.
function gain = gainOf (U, y, s2)
  c = (U - mean (U, 1))' * (y - mean (y)) / (rows (U) - 1);
  gain = sum (c.^2) / (var (y) + s2) / sum (var (U, 0, 1));
end

% Total Sobol indices on the surrogates, d x T: shares of the variance of a
% response over the box (Jansen 1999; the error is about 0.03). A constant
% response gives zeros.
function total = totalIndices (surrogates, problem)
  d = columns (problem.limits);
  U = sampleBox (1024, [zeros(1, 2 * d); ones(1, 2 * d)]);
  A = fromUnit (U(:, 1:d), problem.limits);
  B = fromUnit (U(:, d + 1:end), problem.limits);
  fA = predictSurrogate (surrogates, A);
  fB = predictSurrogate (surrogates, B);
  centre = mean ([fA; fB], 1);
  fA = fA - centre;
  variance = mean ([fA; fB - centre].^2, 1);
  variance(variance < 1e-20 * centre.^2) = Inf;
  total = zeros (d, numel (surrogates));
  for j = 1:d
    C = A;
    C(:, j) = B(:, j);
    fC = predictSurrogate (surrogates, C) - centre;
    total(j, :) = 0.5 * mean ((fA - fC).^2, 1) ./ variance;
  end
end

% What a measurement is off by: the parameters that the targets leave open, the
% surrogate, the scatter of one packing, or of the mean of so many trials, and the
% measurement's own error. Where no parameters fit, the set speaks for itself.
function hold = predictHoldout (state, problem, known)
  hold = [];
  sample = known.sample;
  if strcmp (known.code, 'no fit')
    sample = sample([], :);
  end
  [m, v] = predictSurrogate (state.surrogates, [state.found.params; sample]);
  isHeld = ~problem.calibrate & ~ismember (problem.targetNames, state.unjudged);
  for t = find (isHeld)
    s = state.surrogates(t);
    value = problem.value(t);
    [sd, df] = missOf (v(:, t), s, problem, t);
    score = @(u) studentQuantile (u, df) / studentQuantile (0.8413, df);
    alone = m(1, t) + score (0.95) * sd(1) * [-1; 1];
    % of each set of the sample 40 measurements that are as likely
    each = m(2:end, t) + sd(2:end, 1) .* arrayfun (score, ((1:40) - 0.5) / 40);
    ends = [alone, quantile([each(:); alone], [0.05; 0.95], 1, 7)];
    ends = [min(ends(1, :)); max(ends(2, :))];
    isIn = @(ends) value >= ends(1) && value <= ends(2);
    total = sqrt (mean (sd.^2) + var (m(:, t), 1));
    entry = struct ('name', s.name, 'model', problem.benchNames{problem.bench(t)}, ...
                    'target', value, 'result', m(1, t), 'sd', total, ...
                    'interval90', ends, 'inside', isIn (ends), ...
                    'leftOpen', isIn (ends) && ~isIn (alone));
    isUnjudged = strcmp (state.final.state{t}, 'unjudged');
    if isnan (value) || isUnjudged
      entry.inside = NaN;
    end
    if isUnjudged
      [entry.result, entry.sd, entry.interval90(:)] = deal (NaN);
    end
    hold = [hold, entry];
  end
end

% What a measurement of target T may be off by (68 %, n x 1), and the usual freedom of it
% (Welch and Satterthwaite): runs tell a scale, and few trials less than many.
function [sd, df] = missOf (v, s, problem, t)
  total = errorVariance (s.noiseVar, problem, t);
  measured = problem.statedSd(t)^2 * (total > s.noiseVar / problem.trials(t));
  shared = min (problem.shared(t)^2, measured);
  doubt = measured^2 / problem.freedom(t) + shared^2 / problem.sessionFreedom(t) + ...
          (measured - shared)^2 / problem.commonFreedom(t);
  runs = (v + total - measured) * studentQuantile (0.8413, s.df)^2;
  sd = sqrt (runs + measured);
  df = median (max (sd.^4, realmin) ./ max (runs.^2 / s.df + doubt, realmin));
end

% What each level has told and cost, at the found set, 1 x L struct: value (1 x
% v, of the level variables), runs, seconds (of a run; NaN: not known), shift
% and shiftSd (1 x T: response there less that at the last level, and how well
% it is known; 0 for a model without levels), noiseSd (1 x T, of a run), dropped
% (1 x T: the surrogate does not hold its runs; the others are NaN then).
function levels = describeLevels (state, problem)
  levels = [];
  if isempty (problem.coarse)
    return
  end
  [~, ~, seconds] = budgetLeft (state, problem);
  seconds(end + 1:rows (problem.coarse.levels)) = NaN;
  for k = 1:rows (problem.coarse.levels)
    value = problem.coarse.levels(k, :);
    one = struct ('value', value, ...
                  'runs', sum (all (state.data.E == value, 2)), ...
                  'seconds', seconds(k), 'shift', [], 'shiftSd', [], ...
                  'noiseSd', [], 'dropped', false);
    for t = 1:numel (state.surrogates)
      s = state.surrogates(t);
      level = unitLevel (problem.coarse, value, t);
      one.dropped(t) = any (s.dropped == level);
      [one.shift(t), one.shiftSd(t), one.noiseSd(t)] = ...
        levelShift (s, state.final.params, level);
    end
    levels = [levels, one];
  end
end

%!function c = sumOf (state, problem)
%!  state.found.conflict = {};
%!  state.final = confirmSet (state, problem);
%!  state.final.untested = [];
%!  c = newCalibration (state, problem, struct ('models', 1));
%!endfunction
%!test
%! % a held-out target: predicted, outside where it is said so, named
%! [problem, state] = smallCalibration ();
%! problem.calibrate = [true, false];
%! c = sumOf (state, problem);
%! assert (c.holdout.result, 1.9, 0.05);
%! assert (c.demRuns.plan, 12);
%! assert (c.sensitivity, [0.5, 0.61; 0.5, 0.39], 0.06);
%! problem.value(2) = 1.9;
%! assert (sumOf (state, problem).holdout.inside);
%! problem.value(2) = 3;
%! c = sumOf (state, problem);
%! assert (~ c.holdout.inside);
%! assert (any (strncmp (c.warnings, 'target y', 8)));
%! problem.value(2) = NaN;
%! assert (isnan (sumOf (state, problem).holdout.inside));
%! assert (isempty (c.levels));
%! % read twice: Student's t of one freedom; its scatter holds the packings of the trials
%! problem.scatter(2) = true;
%! problem.statedSd(2) = 30 * sqrt (state.surrogates(2).noiseVar);
%! width = @(problem) diff (sumOf (state, problem).holdout.interval90);
%! known = width (problem);
%! assert (known, 2 * 1.645 * problem.statedSd(2), 0.05 * known);
%! problem.freedom(2) = 1;
%! assert (width (problem) / known, 6.31 / 1.84 / 1.645, 0.1);
%! problem.statedSd(2) = sqrt (state.surrogates(2).noiseVar);
%! [problem.freedom(2), problem.trials(2)] = deal (Inf, 1);
%! once = width (problem);
%! problem.statedSd(2) = 0;
%! assert (width (problem), once, 0.02 * once);
%!test
%! % the one target fixes a + b; a - b, held out, may be anything, and that is said
%! % rather than that the model is wrong
%! [problem, state] = smallCalibration ();
%! law = @(X) [X(:, 1) + X(:, 2) / 2 + 2, X(:, 1) - X(:, 2) / 2 + 2];
%! state.data.Z = law (state.data.X) + 0.005 * randn (12, 2);
%! [problem.value, problem.calibrate] = deal ([3, 2.5], [true, false]);
%! state.surrogates = fitSurrogates (state.data, problem);
%! state.found = describeSet (state.surrogates, problem, [0.5, 1]);
%! held = sumOf (state, problem).holdout;
%! assert ([held.inside, held.leftOpen], [true, true]);
%! assert (diff (held.interval90) > 1);
%! problem.value(2) = 4;
%! held = sumOf (state, problem).holdout;
%! assert ([held.inside, held.leftOpen], [false, false]);
%!test
%! % what each level has told and cost
%! rand ('twister', 4);
%! randn ('twister', 4);
%! C = struct ('names', {{'a', 'b'}}, 'limits', [0, 0; 1, 1]);
%! C.targets = struct ('value', {1, 0.4}, 'tol', 0.01, 'model', {1, 2});
%! C.coarse = struct ('variable', 'scaleP', 'levels', [2, 1], 'models', 1);
%! problem = newProblem (C);
%! X = rand (16, 2);
%! E = [2 * ones(8, 1); ones(8, 1)];
%! Z = [sum(X, 2) + 0.3 * (E - 1), X(:, 1)] + 0.005 * randn (16, 2);
%! data = addRows (newData (2, 2, 1), X, Z, ones (16, 1), 'plan', E);
%! s = fitSurrogates (data, problem);
%! state = newState (data, s, describeSet (s, problem, [0.4, 0.6]));
%! levels = sumOf (state, problem).levels;
%! assert ([levels.value; levels.runs], [2, 1; 8, 8]);
%! assert (levels(1).shift, [0.3, 0], 0.02);
%! assert (levels(1).shiftSd(1) < 0.02);
%! assert (levels(2).shift, [0, 0]);
%! state.surrogates(1).dropped = 1;
%! levels = sumOf (state, problem).levels;
%! assert (isnan (levels(1).shift), [true, false]);
%! assert (levels(1).dropped, [true, false]);
%!test
%! % y = a + b fixes the sum, not the difference; c is not fixed at all
%! rand ('twister', 1);
%! randn ('twister', 1);
%! problem = smallProblem (1, 0.01, 3);
%! X = rand (20, 3);
%! data = addRows (newData (3, 1), X, X(:, 1) + X(:, 2) + ...
%!                 0.02 * randn (20, 1), ones (20, 1), 'plan');
%! s = fitSurrogates (data, problem);
%! c = sumOf (newState (data, s, describeSet (s, problem, [0.5, 0.5, 0.5])), ...
%!            problem);
%! assert (any (strcmp (c.notIdentified, 'c')));
%! weak = c.identifiability;
%! assert (columns (weak.directions), 2);
%! assert (sum (weak.directions(1:2, :), 1), [0, 0], 0.35);
%! % c, which the target does not read, is not worth a measurement
%! assert (sort ({weak.next.name}), {'a', 'b'});
%! assert (weak.next(1).gain > 0.2);

% SPDX-License-Identifier: GPL-3.0-only
