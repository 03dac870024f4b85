% TRYMEASUREMENTS  Runs tests that the case does not have: what would they tell?
%
% CALL: [TESTS, STATE] = tryMeasurements (CANDIDATES, STUDY, EVIDENCE, P, STATE)
%
%   CANDIDATES  1 x m struct, those that are to be tried first in front:
%     test (text), model (bench), variable ('': none), value, trials, cost
%     origin   1 x T, of each result the target (number in the given problem)
%              that is the same result of the same bench set up as it is; NaN
%     noise    1 x T, scatter of one run where the result has the size
%     size     1 x T; NaN: those of the origin, else of all in proportion
%     sd       1 x T, uncertainty of a reading; NaN: that of the origin, else as
%              large as the scatter of a run
%     effects  1 x K struct offset, matrix: what effects of the laboratory do to
%              these results (newEffect)
%     isExpressed  1 x K logical, effects that the bench can have (K + 1: none)
%     evaluate of newEvaluate, of this bench alone;  lines  cellstr, goes on
%   STUDY, EVIDENCE, STATE  see adviseMeasurements;  P  1 x H, probabilities of EVIDENCE
%   TESTS   1 x n struct as of nextMeasurement, of those that ran; isFirm: chosen to
%           have more runs than all have
%
% Compared are the null model and the three likeliest kinds of cause. Each
% candidate has four runs, one at the mode of each: their differences hold what
% the cause does there and what the other parameters do that it has. All get
% four more at draws of the posterior, as long as that leaves as much for the
% best; of the rest of options.testRuns half goes to the three that promise
% most, half to two (sequential halving; Karnin, Koren and Somekh 2013): four
% runs seldom tell a test from scatter, sixteen not always. likelyKinds says
% what is asked: which kind, or whether it is the likeliest.

function [tests, state] = tryMeasurements (candidates, study, evidence, P, state)
  options = study.hypotheses.options;
  [causes, sets, names] = explanations (study, evidence, P, options);
  ask = struct ('causes', {causes}, 'sets', {sets}, 'afford', ...
                min (state.budget.left, options.testRuns));
  [tests, ask, state] = firstRuns (candidates, study, ask, state);
  if isempty (tests)
    return
  end
  tests = scoreMeasurements (tests, ask.causes);
  for rounds = [3, 2, 1]
    [best, extra] = whichNext (tests, ask, rounds, options.adviseAt / 2);
    for i = best
      [tests(i), state] = runSets (tests(i), study, ask.sets, state, extra);
      tests(i) = scoreMeasurements (tests(i), ask.causes);
      tests(i).isFirm = rounds < 3;
    end
  end
  tests = asNext (tests, names);
end

% One run of each explanation with each candidate. Where the null model ran and
% an explanation did not, with the first candidate, this is taken for one that
% the program cannot have, as cohesion beside liquid bridges: the tests go on
% without it, and find the other runs again.
function [tests, ask, state] = firstRuns (candidates, study, ask, state)
  tests = [];
  if isempty (ask.causes)
    return
  end
  % four runs each; 24 are kept for those that promise most
  most = max (floor ((ask.afford - 24) / 4), floor (min (ask.afford, 24) / 4));
  for candidate = candidates
    canHave = ismember ([ask.sets.number], find (candidate.isExpressed));
    if numel (tests) >= most || ~all (canHave)
      continue
    end
    [test, state] = runSets (candidate, study, ask.sets, state, 0);
    if isempty (tests) && test.ran(1) && ~all (test.ran)
      ask = without (ask, test.ran);
      if isscalar (unique ([ask.causes.kind]))
        return
      end
      [test, state] = runSets (candidate, study, ask.sets, state, 0);
    end
    if ~isempty (test.Z)
      tests = [tests, test];
    end
  end
end

function ask = without (ask, ran)
  ask.sets = ask.sets(ran);
  ask.causes = ask.causes(ran([ask.causes.group]));
  number = cumsum (ran);
  total = sum ([ask.causes.P]);
  for i = 1:numel (ask.causes)
    ask.causes(i).group = number(ask.causes(i).group);
    ask.causes(i).P = ask.causes(i).P / total;
  end
end

function [best, extra] = whichNext (tests, ask, rounds, least)
  [n, spent] = deal (numel (tests), numel (vertcat (tests.group)));
  % in rounds of one run of each explanation
  room = floor ((ask.afford - spent) / numel (ask.sets));
  if rounds == 3
    [best, extra] = deal (1:n * (room >= 2 * n), 1);
    return
  end
  room = floor (room / rounds);
  best = bestOf (tests, min (rounds + 1, room), least);
  extra = min (floor (room / max (numel (best), 1)), 3);
end

% None, where the best one is sure: scatter takes little of what it promises.
function best = bestOf (tests, n, least)
  [~, best] = sort (-[tests.promise] ./ [tests.cost]);
  first = tests(best(1));
  isSure = numel (first.group) >= 16 && first.gain > 0.8 * first.promise;
  best = best([tests(best).promise] >= least & ~isSure);
  best = best(1:min (n, numel (best)));
end

% With the results of MORE further runs of each explanation, 0: of the first one
% of each; its Z is empty where a first run was not made or gave no result. RAN:
% each explanation gave results, or its runs were not made. Equal draws have
% packings of their own.
function [test, state] = runSets (test, study, sets, state, extra)
  problem = study.problem;
  isFirst = extra == 0;
  known = 0;
  if ~isFirst
    known = rows (test.Z) / numel (sets);
  end
  Q = zeros (0, study.emulator.p + numel (problem.effects));
  [group, packing] = deal (zeros (0, 1));
  for g = 1:numel (sets)
    own = sets(g).mode;
    if ~isFirst
      own = sets(g).draws(known - 1 + (1:extra), :);
    end
    row = zeros (rows (own), columns (Q));
    row(:, [1:study.emulator.p, study.emulator.p + sets(g).number]) = own;
    Q = [Q; row];
    group = [group; g * ones(rows (own), 1)];
    packing = [packing; known + (1:rows (own))'];
  end
  [Z, state] = results (test, problem, Q, packing, state);
  if isFirst
    test.ran = true (1, numel (sets));
    [test.Z, test.group] = deal (zeros (0, columns (Z)), zeros (0, 1));
  end
  if isFirst && rows (Z) == rows (Q)
    test.ran = all (isfinite (Z), 2)';
  end
  if ~all (isfinite (Z(:))) || rows (Z) < rows (Q)
    return
  end
  test.Z = [test.Z; Z];
  test.group = [test.group; group];
  if isFirst
    test.doubt = [sets.doubt];
    test = withNoise (test, study);
    [test.gain, test.pair, test.promise, test.isFirm] = deal (0, [], 0, false);
  end
end

% The bench has one model, the diagnosis any number: only its counts go on.
function [Z, state] = results (test, problem, Q, packing, state)
  p = columns (problem.limits);
  phi = Q(:, p + 1:end);
  X = fromSymmetric (Q(:, 1:p), problem.limits);
  E = valuesOfStrength (problem.effects, phi);
  own = struct ('data', newData (p, numel (test.origin), columns (E)), ...
                'budget', state.budget, 'evaluate', test.evaluate);
  [own.budget.models, own.budget.sets, own.budget.seconds, ...
   own.budget.levels] = deal (true, Inf, {[]}, []);
  T = numel (test.origin);
  bench = struct ('limits', problem.limits, 'allowed', problem.allowed, ...
                  'names', {problem.names}, 'kept', 1:T, 'unit', ones (1, T), ...
                  'bench', ones (1, T), 'benchNames', {{test.model}});
  own = addRuns (own, bench, X, E, 'next', packing);
  for name = {'left', 'new', 'reused', 'failed', 'coreSeconds'}
    state.budget.(name{1}) = own.budget.(name{1});
  end
  Z = own.data.Z;
  phi = phi(1:rows (Z), :);
  for k = find ([problem.effects(1:numel (test.effects)).laboratory])
    effect = test.effects(k);
    Z = Z + phi(:, k) .* (effect.offset + Z * effect.matrix);
  end
end

% Scatter grows with the result, threefold at most.
function test = withNoise (test, study)
  problem = study.problem;
  null = predictGap (study.emulator, [], study.fits.calibrated.Q(1, :));
  scatter = sqrt (study.emulator.noiseVar);
  now = mean (abs (test.Z), 1);
  usual = median (scatter ./ max (abs (null), realmin));
  for t = 1:numel (test.origin)
    at = find (problem.kept == test.origin(t), 1);
    reading = NaN;
    if ~isempty (at)
      unit = problem.unit(at);
      reading = problem.sd(at) * unit;
      if isnan (test.noise(t))
        test.noise(t) = scatter(at) * unit;
        test.size(t) = abs (null(at)) * unit;
      end
    elseif isnan (test.noise(t))
      [test.noise(t), test.size(t)] = deal (usual * now(t), now(t));
    end
    ratio = min (max (now(t) / max (test.size(t), realmin), 1 / 3), 3);
    test.noise(t) = test.noise(t) * ratio;
    if isnan (test.sd(t))
      test.sd(t) = reading * max (ratio, 1);
    end
    if ~(test.sd(t) > 0)
      test.sd(t) = test.noise(t);
    end
  end
end

function list = asNext (tests, names)
  list = [];
  for test = tests
    one = struct ('targets', [], 'gainPerCost', test.gain / test.cost, ...
                  'between', {names(test.pair)}, 'runs', rows (test.Z));
    for name = {'test', 'gain', 'cost', 'model', 'variable', 'value', ...
                'trials', 'lines', 'isFirm'}
      one.(name{1}) = test.(name{1});
    end
    list = [list, one];
  end
end

%!test
%! % an explanation that no bench can have does not stop the others
%! pkg load stk
%! [given, data, means] = smallGapLab ();
%! randn ('twister', 4);
%! given.value = means ([0.4, 0.6], [0.6, 0, 0, 0, 0]) + 0.28 * randn (1, 12);
%! study = labStudy (given, data, struct ('twins', 60));
%! study.hypotheses = gapReference (study.hypotheses);
%! evidence = caseEvidence (study.hypotheses, study.fits, 1);
%! P = judgeCase (evidence, study.hypotheses).P;
%! [causes, sets] = explanations (study, evidence, P, study.hypotheses.options);
%! assert (numel (sets), 4);
%! never = sets(4).number;
%! others = setdiff (1:4, never);
%! law = @(X, E) [5 + 4 * E(:, 1), 7 - 3 * E(:, 2) + X(:, 1)] + ...
%!               0 ./ ~(all (E(:, never), 2) & ~any (E(:, others), 2));
%! [f, state.budget] = newEvaluate (@(X, E, r) law (X, E) + ...
%!                                             0.2 * randn (rows (X), 2));
%! % a fifth effect, as a finer level, is not known to the test
%! effects = struct ('offset', repmat ({[0, 0]}, 1, 4), 'matrix', zeros (2));
%! one = struct ('test', 'a bench', 'model', 'Other', 'variable', '', ...
%!               'value', [], 'trials', 3, 'cost', 1, 'origin', [NaN, NaN], ...
%!               'noise', [0.2, 0.2], 'size', [5, 7], 'sd', [0.1, 0.1], ...
%!               'effects', effects, 'isExpressed', true (1, 4), ...
%!               'evaluate', f, 'lines', {{}});
%! tests = tryMeasurements (one, study, evidence, P, state);
%! assert (numel (tests), 1);
%! assert (tests.gain > 0.2 && tests.isFirm);

% SPDX-License-Identifier: GPL-3.0-only
