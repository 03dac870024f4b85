% TRYTESTS  Runs tests that the case does not have: what would they tell?
%
% CALL: [TESTS, STATE] = tryTests (MAKE, STUDY, W, P, STATE)
%
%   MAKE    handle without arguments, gives the candidates, those that are to be
%           tried first in front: 1 x m struct
%     test (text), model (bench), variable ('': as it stands), value, trials,
%     cost
%     origin   1 x T, of each result the target (number in the given problem)
%              that is the same result of the same bench set up as it is; NaN
%     noise    1 x T, scatter of one run where the result has the size
%     size     1 x T; NaN: those of the origin, else of all in proportion
%     sd       1 x T, uncertainty of a reading; NaN: that of the origin, else as
%              large as the scatter of a run
%     effects  1 x K struct offset, matrix: what effects of the laboratory do to
%              these results (newEffect)
%     isExpressed  1 x K logical, effects that the bench can have
%     evaluate of newEvaluate, of this bench alone;  lines  cellstr, goes on
%   STUDY, W, STATE  see adviseTests;  P  1 x H, probabilities of W
%   TESTS   1 x n struct as of nextTest, of those that ran
%
% Compared are the null model and the three likeliest kinds of cause. Each
% candidate has four runs, one at the mode of each: their differences hold what
% the cause does there and what the other parameters do that it has. What is
% left of options.testRuns goes in two halves to the three and then to the two
% that promise most, at draws of the posterior (sequential halving; Karnin,
% Koren and Somekh 2013): four runs alone seldom tell a test from scatter.
%
% likelyKinds says what is asked: which kind, or whether it is the likeliest.

function [tests, state] = tryTests (make, study, w, P, state)
  options = study.models.options;
  tests = [];
  [causes, sets, names] = explanations (study, w, P, options);
  if isempty (causes)
    return
  end
  afford = min (state.budget.left, options.testRuns);
  most = max (floor ((afford - 24) / 4), floor (min (afford, 24) / 4));
  for candidate = make ()
    if numel (tests) >= most || ~all (candidate.isExpressed([sets.number]))
      continue
    end
    [test, state] = runSets (candidate, study, sets, state, 0);
    if ~isempty (test)
      tests = [tests, test];
    end
  end
  if isempty (tests)
    return
  end
  tests = scoreTests (tests, causes);
  for rounds = [2, 1]
    spent = numel (vertcat (tests.group));
    room = floor ((afford - spent) / rounds / numel (sets));
    best = bestOf (tests, min (rounds + 1, room), options.adviseAt / 2);
    for i = best
      [tests(i), state] = runSets (tests(i), study, sets, state, ...
                                   min (floor (room / numel (best)), 3));
      tests(i) = scoreTests (tests(i), causes);
    end
  end
  tests = asNext (tests, names);
end

% None, where the best one is sure: scatter takes little of what it promises.
function best = bestOf (tests, n, least)
  [~, best] = sort (-[tests.promise] ./ [tests.cost]);
  first = tests(best(1));
  isSure = numel (first.group) >= 16 && first.gain > 0.8 * first.promise;
  best = best([tests(best).promise] >= least & ~isSure);
  best = best(1:min (n, numel (best)));
end

% Sets of the explanations: the mode, and draws of the posterior. CAUSES is
% empty where nothing of weight is open.
function [causes, sets, names] = explanations (study, w, P, options)
  causes = [];
  sets = setOf (study, w, find (strcmp (w.kind, 'null'), 1), options);
  [keep, P, kinds, names] = likelyKinds (w, P, study.models.names);
  if isscalar (names)
    return
  end
  group = explanationOf (w, keep, P);
  own = group <= 3;
  [group, keep, kinds] = deal (group(own), keep(own), kinds(own));
  P = P(own) / sum (P(own));
  causes = struct ('P', num2cell (P), 'group', num2cell (group + 1), ...
                   'kind', num2cell (kinds), 'extent', 0);
  for g = 1:max (group)
    [~, at] = max (P .* (group == g));
    sets(end + 1) = setOf (study, w, keep(at), options);
  end
  for i = find (strcmp (w.kind(keep), 'sibling'))
    posterior = w.posterior{keep(i)};
    causes(i).extent = sqrt (posterior.weight' * posterior.Q(:, end).^2);
  end
end

% Explanation of each hypothesis: the null model (0) or one of the likely sets
% of effects, of which a sibling has those of its effect.
function group = explanationOf (w, keep, P)
  texts = cellfun (@(m) mat2str (sort (m)), w.members(keep), ...
                   'UniformOutput', false);
  [~, ~, number] = unique (texts);
  weight = accumarray (number(:), P(:));
  weight(number(strcmp (w.kind(keep), 'null'))) = Inf;
  [~, order] = sort (-weight);
  rank(order) = (1:numel (order)) - isinf (max (weight));
  group = rank(number(:)');
end

% DOUBT: variance that comes with the surrogates over that of a measurement,
% median over the targets, where the explanation fits best.
function set = setOf (study, w, h, options)
  members = w.members{h};
  p = study.em.p;
  columns_ = 1:p + numel (members);
  Q = study.fits.calibrated.Q(1, :);
  if ~isempty (members)
    Q = fitEffects (study.models, study.fits, 1, members, ...
                    study.models.prior).Q;
  end
  set = struct ('mode', Q(1, columns_), 'draws', [], 'number', [], ...
                'doubt', []);
  white = study.models.white;
  n = numel (white.columns);
  noise = noiseBudget (study.gapProblem, study.em).covariance;
  own = sum ((white.W(1:n, :) * noise(white.columns, white.columns)) .* ...
             white.W(1:n, :), 2)';
  [~, V] = predictGap (white, members, set.mode);
  set.doubt = max (median (V(1:n) ./ own) - 1, 0);
  [~, set.number] = ismember (study.models.names(members), ...
                              {study.gapProblem.effects.name});
  posterior = w.posterior{h};
  n = options.testRuns / 4;
  set.draws = repmat (set.mode, n, 1);
  if ~isempty (posterior.Q)
    u = integrationPoints (n, 1, options.seed + h).uniform;
    at = sum (cumsum (posterior.weight)' < u, 2) + 1;
    at = min (at, rows (posterior.Q));
    set.draws = posterior.Q(at, columns_);
  end
end

% With the results of MORE further runs of each explanation, 0: of the first one
% of each; [] where a first run was not made or gave no result. Equal draws have
% packings of their own.
function [test, state] = runSets (test, study, sets, state, more)
  gapProblem = study.gapProblem;
  isFirst = more == 0;
  known = 0;
  if ~isFirst
    known = rows (test.Z) / numel (sets);
  end
  Q = zeros (0, study.em.p + numel (gapProblem.effects));
  [group, packing] = deal (zeros (0, 1));
  for g = 1:numel (sets)
    own = sets(g).mode;
    if ~isFirst
      own = sets(g).draws(known - 1 + (1:more), :);
    end
    row = zeros (rows (own), columns (Q));
    row(:, [1:study.em.p, study.em.p + sets(g).number]) = own;
    Q = [Q; row];
    group = [group; g * ones(rows (own), 1)];
    packing = [packing; known + (1:rows (own))'];
  end
  [Z, state] = results (test, gapProblem, Q, packing, state);
  if ~all (isfinite (Z(:))) || rows (Z) < rows (Q)
    test = test(~isFirst);
    return
  end
  if isFirst
    [test.Z, test.group] = deal (zeros (0, columns (Z)), zeros (0, 1));
    test.doubt = [sets.doubt];
  end
  test.Z = [test.Z; Z];
  test.group = [test.group; group];
  if isFirst
    test = withNoise (test, study);
    [test.gain, test.pair, test.promise] = deal (0, [], 0);
  end
end

% The bench has one model, the diagnosis any number: only its counts go on.
function [Z, state] = results (test, gapProblem, Q, packing, state)
  p = columns (gapProblem.limits);
  phi = Q(:, p + 1:end);
  X = mean (gapProblem.limits) + Q(:, 1:p) .* diff (gapProblem.limits) / 2;
  E = valuesOfStrength (gapProblem.effects, phi);
  own = struct ('data', newData (p, numel (test.origin), columns (E)), ...
                'budget', state.budget, 'evaluate', test.evaluate);
  [own.budget.perSet, own.budget.seconds, own.budget.levels] = ...
    deal (1, {[]}, []);
  own = addRuns (own, gapProblem, X, E, 'next', packing);
  for name = {'left', 'new', 'reused', 'failed', 'coreSeconds'}
    state.budget.(name{1}) = own.budget.(name{1});
  end
  Z = own.data.Z;
  phi = phi(1:rows (Z), :);
  for k = find ([gapProblem.effects.laboratory])
    effect = test.effects(k);
    Z = Z + phi(:, k) .* (effect.offset + Z * effect.matrix);
  end
end

% Scatter grows with the result, threefold at most.
function test = withNoise (test, study)
  gapProblem = study.gapProblem;
  null = predictGap (study.em, [], study.fits.calibrated.Q(1, :));
  scatter = sqrt (study.em.noiseVar);
  now = mean (abs (test.Z), 1);
  usual = median (scatter ./ max (abs (null), realmin));
  for t = 1:numel (test.origin)
    at = find (gapProblem.kept == test.origin(t), 1);
    reading = NaN;
    if ~isempty (at)
      unit = gapProblem.unit(at);
      reading = gapProblem.sd(at) * unit;
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
                'trials', 'lines'}
      one.(name{1}) = test.(name{1});
    end
    list = [list, one];
  end
end
