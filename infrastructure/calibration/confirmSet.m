% CONFIRMSET  Judges the found set by the DEM runs made there.
%
% CALL: FINAL = confirmSet (STATE, PROBLEM)
%
% FINAL  params 1 x d, n (successful runs there; equal ones count once, see
%        countEqualOnce), equal (how many that leaves out), result 1 x T (their
%        mean; the surrogate mean if n = 0), sd 1 x T (standard error of that
%        mean), noiseSd 1 x T (noise of one run), residual T x 1 (of the mean),
%        residualSd T x 1, interval90 2 x T (of the true response), estimate
%        1 x T (its middle), state 1 x T cell: 'met' where the mean of the
%        runs and the estimate are within the tolerance, 'missed' where neither
%        is, 'unjudged' (see there), else 'open' (the points of a curve as one),
%        open (cellstr, fitted
%        results of which the mean of the runs misses), met 1 x T (state is
%        'met'; without runs: the estimate is within), probability, within (the
%        estimate, with a run), converged, outcomes (struct: usual and other,
%        runs at the set that ended as most do and in another way, result 1 x T
%        of the others (NaN: none), none and resulting, runs at the set without and
%        with a result, share expected of other ones, onceMore
%        (probability after all runs that the budget allows, none of them odd)),
%        unjudged (1 x u struct: name, lacks, tried, isFit (a target, not held out):
%        results that too many runs near the set lack, see lackingAt and leaveUnjudged),
%        isRestConfirmed (logical: converged but for these),
%        conflict, ending (see newEnding), reason (its text), limit
%        ('maxFunEvals', 'maxNewRuns', 'maxIter': what ended the search;
%        'unsettled': none of them, but the runs that are left would not settle it;
%        '': converged)
%
% The truth at the set is known from the surrogate, which holds its runs; where
% the two disagree by more than options.apart standard errors the runs stand
% alone (with their own scatter where that is the larger one, and n - 1 degrees
% of freedom then).
%
% converged: the truth's estimate within the tolerances, at least
% options.replicates runs, probability at least options.confidence, no result open
% (a surrogate outvotes no run of its set: further runs decide), none unjudged, and
% packings without a result are few (tooOftenNone). How many
% runs that takes beyond the asked ones is for the probability to say: runs of
% other sets, along slopes that the surrogate knows, tell as much as those at
% the set.

function final = confirmSet (state, problem)
  p = state.found.params;
  isHere = sameSet (state.data.X, p, problem.limits);
  [Z, nEqual] = runsAt (isHere, state, problem);
  n = rows (Z);
  noiseSd = sqrt ([state.surrogates.noiseVar]);
  [expected, v] = predictSurrogate (state.surrogates, p);
  m = expected;
  df = [state.surrogates.df];
  final = struct ('params', p, 'result', m, 'sd', sqrt (v + noiseSd.^2), ...
                  'noiseSd', noiseSd, 'n', n, 'equal', nEqual, ...
                  'outcomes', resultsAt (isHere, state, problem));
  if n > 0
    final.result = mean (Z, 1);
    final.sd = noiseSd / sqrt (n);
    alone = abs (final.result - m) > problem.options.apart * final.sd;
    scatter = sqrt (sum ((Z - final.result).^2, 1) / max (n - 1, 1));
    if n > 2                             % the noise may be less here than elsewhere
      far = studentQuantile (erfc (-problem.options.apart / sqrt (2)) / 2, n - 1);
      alone = alone | abs (final.result - m) > far * scatter / sqrt (n);
    end
    s = max (scatter, noiseSd) / sqrt (n);
    m(alone) = final.result(alone);
    v(alone) = s(alone).^2;
    few = alone & scatter > noiseSd;
    df(few) = min (df(few), max (n - 1, 1));
  end
  problem.odd = oddRuns (state, problem);
  final.unjudged = unjudgedAt (p, state, problem);
  final = judgeSet (final, m, v, df, problem, budgetLeft (state, problem));
  final.outcomes = mergeFields (final.outcomes, ...
                                otherRuns (problem.odd, isHere, expected, n));
  final.conflict = state.found.conflict;
  [left, final.limit] = budgetLeft (state, problem);
  if final.converged
    final.limit = '';
  elseif left > 0 && state.wrong < problem.options.maxIter
    final.limit = 'unsettled';
  elseif left > 0
    final.limit = 'maxIter';
  end
  final.ending = endingOf (final, any (isHere), problem.options);
  final.reason = final.ending.text;
  final = withoutUnjudged (final, problem);
end

% Of the runs that have such a result nothing is said: they are not a sample of all.
function final = withoutUnjudged (final, problem)
  is = ismember (problem.targetNames, {final.unjudged.name});
  [final.result(is), final.estimate(is), final.sd(is)] = deal (NaN);
  [final.residual(is), final.residualSd(is)] = deal (NaN);
  final.interval90(:, is) = NaN;
  final.met(is) = false;
  final.state(is) = {'unjudged'};
end

function [Z, nEqual] = runsAt (isHere, state, problem)
  data = state.data;
  [~, isRepeat] = countEqualOnce (data, problem.bench);
  nEqual = sum (isRepeat & isHere);
  data.Z(horzcat (state.surrogates.leftOut)) = NaN;
  data.Z(isRepeat | ~isHere, :) = NaN;
  Z = runsThatCount (data, problem).Z;
  isThere = isfinite (Z) | ~problem.calibrate;
  Z = Z(all (isThere, 2), :);
end

% What the runs there too often lack, and what was set aside for that: name, lacks and
% tried (how many runs near the set lack it, of how many), isFit (a target, not held out).
function list = unjudgedAt (p, state, problem)
  [chance, lacks, tried] = lackingAt (p, state.data, problem);
  isAside = ismember (problem.targetNames, state.unjudged);
  isOut = (isfinite (problem.value) & chance > 0.5) | isAside;
  isFit = problem.calibrate | isAside;
  list = struct ('name', problem.targetNames(isOut), 'lacks', num2cell (lacks(isOut)), ...
                 'tried', num2cell (tried(isOut)), 'isFit', num2cell (isFit(isOut)));
end

% How many runs at the set have no result, how many have one. An imported row
% without one may be a result that nobody read.
function outcomes = resultsAt (isHere, state, problem)
  isOwn = isHere & ~strcmp (state.data.stage, 'import');
  data = runsThatCount (keepRows (state.data, isOwn), problem);
  isNone = any (isnan (data.Z(:, problem.calibrate)) & ...
                ~isna (data.Z(:, problem.calibrate)), 2);
  outcomes = struct ('none', sum (isNone), 'resulting', sum (~isNone));
end

% Of N runs at the set that count, those that ended in another way, beside those
% that were left out.
function outcomes = otherRuns (odd, isHere, expected, n)
  outcomes = struct ('usual', n, 'other', 0, 'result', NaN (size (expected)));
  if isempty (odd)
    return
  end
  isHere = isHere(odd.rows);
  outcomes.other = sum (isHere & odd.isOdd);
  outcomes.usual = sum (isHere & ~odd.isOdd);
  if outcomes.other > 0
    outcomes.result = expected + mean (odd.jump(isHere(odd.isOdd), :), 1);
  end
end

function final = judgeSet (final, m, v, df, problem, left)
  final.residual = targetResidual (problem, final.params, final.result)';
  [r, slope] = targetResidual (problem, final.params, m);
  final.residualSd = (abs (slope) .* final.sd)';
  s = abs (slope) .* sqrt (v);
  at = final.params;
  [final.probability, share] = mixtureMet (r, s, problem, df, at);
  if ~isempty (problem.odd)
    problem.odd.further = left;
  end
  final.outcomes.share = share;
  final.outcomes.onceMore = mixtureMet (r, s, problem, df, at);
  final.outcomes.alone = allMet (r, s, problem, df);
  half = arrayfun (@(df) studentQuantile (0.95, df), df) .* sqrt (v);
  final.interval90 = [m - half; m + half];
  share = toleranceShare (problem, r);
  final.estimate = m;
  final = judgeTargets (final, problem, share);
  final.within = final.n > 0 && all (share <= 1);
  isConfirmed = final.within && final.n >= problem.options.replicates && ...
                final.probability >= problem.options.confidence && ...
                isempty (final.open) && ~lacksResults (final);
  final.converged = isConfirmed && ~any ([final.unjudged.isFit]);
  final.isRestConfirmed = isConfirmed;
end

% SHARE  of its tolerance, of each requirement, as all runs together see it.
function final = judgeTargets (final, problem, share)
  T = numel (problem.value);
  byRuns = toleranceShare (problem, final.residual');
  final.state = repmat ({'open'}, 1, T);
  final.met = false (1, T);
  [groups, names] = requirementsOf (problem);
  final.expected = [sum(share > 1), numel(groups)];    % outside, of all
  final.open = names(byRuns > 1 & final.n > 0);
  for g = 1:numel (groups)
    within = [share(g), byRuns(g)] <= 1;
    final.met(groups{g}) = within(1) && (within(2) || final.n == 0);
    if final.n > 0 && all (within)
      final.state(groups{g}) = {'met'};
    elseif final.n > 0 && ~any (within)
      final.state(groups{g}) = {'missed'};
    end
  end
end

function yes = lacksResults (final)
  o = final.outcomes;
  yes = tooOftenNone (o.none, o.none + o.resulting) > 0.5;
end

% Why no set is within. A conflict comes first: no limit that is raised would
% help.
function code = outsideCode (final, hasRun)
  if ~isempty (final.conflict)
    code = 'conflict';
  elseif final.n == 0 && hasRun
    code = 'allFailed';
  elseif final.n == 0
    code = 'notRun';
  else
    code = 'outside';
  end
end

function ending = endingOf (final, hasRun, options)
  isMixed = final.outcomes.alone >= options.confidence && ...
            final.probability < options.confidence;
  if final.converged
    code = 'converged';
  elseif any ([final.unjudged.isFit])
    code = 'unjudged';
  elseif ~final.within
    code = outsideCode (final, hasRun);
  elseif lacksResults (final)
    code = 'noResult';
  elseif isMixed
    code = 'twoOutcomes';
  elseif final.n < options.replicates && final.equal > 0
    code = 'equalRuns';
  elseif final.n < options.replicates
    code = 'fewRuns';
  elseif ~isempty (final.open)
    code = 'open';
  else
    code = 'unsure';
  end
  numbers = struct ('runs', final.n, 'outside', final.expected(1), ...
                    'targets', final.expected(2), 'names', {final.open});
  numbers = mergeFields (numbers, final, {'equal', 'probability', ...
                                          'conflict', 'limit'});
  numbers = mergeFields (numbers, final.outcomes, {'usual', 'other', 'share', ...
                                                   'none', 'resulting'});
  if strcmp (code, 'unjudged')
    out = final.unjudged([final.unjudged.isFit]);
    numbers.names = {out.name};
    numbers.restMet = final.within;
    numbers.none = max ([out.lacks]);
    numbers.resulting = max ([out.tried]) - numbers.none;
  end
  ending = newEnding (code, numbers, options);
end

%!shared problem, state
%! rand ('twister', 1);
%! randn ('twister', 1);
%! problem = smallProblem (1.5, 0.05, 1, struct ('options', struct ('replicates', 2)));
%! X = rand (10, 1);
%! data = addRows (newData (1, 1), X, 1 + X + 0.01 * randn (10, 1), ...
%!                 ones (10, 1), 'plan');
%! state = newState (data, fitSurrogates (data, problem), ...
%!                   struct ('params', 0.5, 'conflict', {{}}));

%!test
%! final = confirmSet (state, problem);
%! assert (~ final.converged && final.n == 0);
%! state.evaluate = newEvaluate (@(P, E, r) 1 + P + 0.01 * (r - 1.5));
%! s = runAndFit (state, problem, [0.5; 0.5], 'verify');
%! final = confirmSet (s, problem);
%! assert (final.converged && final.n == 2);
%! assert (final.residual, 0, 1e-9);
%! assert (final.interval90(1) < 1.5 && final.interval90(2) > 1.5);

%!test
%! % NaN is never a success; a run outside the tolerance neither
%! state.evaluate = newEvaluate (@(P, E, r) NaN (rows (P), 1));
%! s = runAndFit (state, problem, 0.5, 'verify');
%! assert (~ confirmSet (s, problem).converged);
%! state.evaluate = newEvaluate (@(P, E, r) 2 + 0 * P);
%! s = runAndFit (state, problem, [0.5; 0.5], 'verify');
%! assert (~ confirmSet (s, problem).converged);

%!test
%! % runs that stand alone against the surrogate, with a scatter of their own
%! z = [2; 2.2; 1.8; 2.1];
%! s = state;
%! s.data = addRows (s.data, 0.5 * ones (4, 1), z, (1:4)', 'verify');
%! final = confirmSet (s, problem);
%! half = studentQuantile (0.95, 3) * std (z) / 2;
%! assert (final.interval90, mean (z) + [-half; half], 1e-9);

%!test
%! % noise of a table that is two: ten runs that are alike are not outvoted by it
%! z = 1.427 + 0.002 * (-4.5:4.5)';
%! s = state;
%! half = (-1).^(1:10)' * 0.1;
%! s.data.Z = s.data.Z + half;
%! s.surrogates = fitSurrogates (s.data, problem);
%! s.data = addRows (s.data, 0.5 * ones (10, 1), z, (1:10)', 'verify');
%! final = confirmSet (s, problem);
%! assert (! final.converged && final.probability < 0.8);

%!test
%! % equal runs of a model that does not use its seed count as one; the next
%! % one is made beside, and that it cannot be confirmed is said
%! state.evaluate = newEvaluate (@(P, E, r) 1 + P + 0.004 * sin (500 * P));
%! s = runAndFit (state, problem, [0.5; 0.5], 'verify');
%! final = confirmSet (s, problem);
%! assert ([final.n, final.equal], [1, 1]);
%! assert (! final.converged);
%! assert (final.ending.code, 'equalRuns');
%! s = runAndFit (s, problem, 0.5, 'replicate');
%! assert (abs (s.data.X(end) - 0.5) > 0 && abs (s.data.X(end) - 0.5) < 0.01);

%!test
%! % a run that misses is not outvoted by the surrogate of the others; further ones
%! % decide
%! state.evaluate = newEvaluate (@(P, E, r) 1.48 + 0.005 * (r - 1));
%! s = runAndFit (state, problem, [0.5; 0.5], 'verify');
%! problem.options.confidence = 0.5;
%! final = confirmSet (s, problem);
%! assert ([final.converged, isempty(final.open), final.within], true (1, 3));
%! problem.tol = 0.009;
%! final = confirmSet (s, problem);
%! assert ({final.converged, final.open, final.within}, {false, {'target_1'}, true});

%!test
%! % four of eight packings without a result, then two of twenty
%! state.evaluate = newEvaluate (@(P, E, r) ...
%!   merge (mod (r, 2) == 0, NaN (size (r)), 1 + P + 0.01 * (mod (r, 5) - 2)));
%! s = runAndFit (state, problem, 0.5 * ones (8, 1), 'verify');
%! final = confirmSet (s, problem);
%! assert ([final.outcomes.none, final.outcomes.resulting, final.n], [4, 4, 4]);
%! assert ({final.converged, final.ending.code}, {false, 'noResult'});
%! assert (! isempty (strfind (final.reason, 'Of 8 runs')));
%! s.evaluate = newEvaluate (@(P, E, r) 1 + P + 0.01 * (mod (r, 5) - 2));
%! s = runAndFit (s, problem, 0.5 * ones (16, 1), 'replicate');
%! assert (confirmSet (s, problem).converged);

%!test
%! % two results of one rig, of which six of eight packings lack the second: nothing is
%! % said of it, however well the others meet it
%! two = smallProblem ([1.5, 2], 0.05);
%! two.bench = [1, 1];
%! X = linspace (0.05, 0.95, 10)';
%! Z = 1 + [X, 2 * X] + 0.01 * randn (10, 2);
%! s = newState (addRows (newData (1, 2), X, Z, ones (10, 1), 'plan'));
%! s.surrogates = fitSurrogates (s.data, two);
%! s.found = struct ('params', 0.5, 'conflict', {{}});
%! s.evaluate = newEvaluate (@(P, E, r) [1 + P + 0.01 * (mod (r, 5) - 2), ...
%!                                       merge(r > 2, NaN, 1 + 2 * P)]);
%! s = runAndFit (s, two, 0.5 * ones (8, 1), 'verify');
%! final = confirmSet (s, two);
%! assert ({final.converged, final.ending.code}, {false, 'unjudged'});
%! assert ({final.unjudged.name, final.unjudged.lacks > 5}, {two.targetNames{2}, true});
%! s.unjudged = two.targetNames(2);
%! two.calibrate = [true, false];
%! final = confirmSet (s, two);
%! assert ([final.n, final.isRestConfirmed, final.converged], [8, 1, 0]);
%! assert (! isempty (strfind (final.reason, 'The other targets are met')));

%!test
%! % the limit that bit is named; a conflict goes before it, without a run too
%! small = problem;
%! small.options.maxFunEvals = 0;
%! final = confirmSet (state, small);
%! assert (final.limit, 'maxFunEvals');
%! assert (~isempty (strfind (final.reason, 'optim.maxFunEvals (0)')));
%! s = state;
%! [s.budget.left, s.budget.isUsedUp] = deal (0, true);
%! assert (confirmSet (s, small).ending.limit, 'maxNewRuns');
%! later = state;
%! for row = {0, 'unsettled'; 2, 'unsettled'; 3, 'maxIter'}'
%!   later.wrong = row{1};
%!   final = confirmSet (later, problem);
%!   assert ({final.converged, final.limit}, {false, row{2}});
%! end
%! s.found.conflict = {'x'};
%! assert (confirmSet (s, small).ending.code, 'conflict');
%! assert (confirmSet (s, small).met, true);

% SPDX-License-Identifier: GPL-3.0-only
