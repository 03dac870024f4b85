% IMPROVEBYINFILL  Adds DEM runs where they help to find the set, and refits.
%
% CALL: STATE = improveByInfill (STATE, PROBLEM, SAY)
%
% Each round places a batch of options.sets runs, refits the surrogates and
% calibrates again, until the found set meets all targets with a probability of
% options.likely (the runs of calibrateOnDEM bring the rest), or it is clear in
% two rounds running that no set can meet them, or the runs contradict those of
% another source (keepApart), or only the runs for
% confirmation are left of the budget. STATE.reason says which. Where there are
% levels, the found set is run at those that have no run yet first.
%
% The sets are those of the criterion: options.infill of PROBLEM, 'ahead' for
% infillAhead; each is a file of its own with that call. Where there are
% levels, those of five such sets are taken that gain most per core-second;
% coarse runs cost at most as much as the runs at the level that counts have
% cost, so a level that misleads costs no more than it would save.

function state = improveByInfill (state, problem, say)
  conflicts = 0;
  round = 0;
  state = nestLevels (state, problem, say);
  while true
    conflicts = (conflicts + 1) * ~isempty (state.found.conflict);
    free = budgetLeft (state, problem) - problem.options.replicates;
    if state.found.probability >= problem.options.likely
      state.reason = 'the found set is likely';
    elseif conflicts > problem.options.conflicts
      state.reason = ['no set meets: ', ...
                      strjoin(state.found.conflict, ', ')];
    elseif ~isempty (nthargout (2, @keepApart, state, problem))
      state.reason = 'own runs contradict those of another source';
    elseif free < 1
      state.reason = 'no runs left for infill';
    else
      round = round + 1;
      n = min (free, max (1, floor (problem.options.sets)));
      say (whyMore (state, problem, n));
      [P, E] = chooseInfill (state, problem, n, round);
      state = oneRound (state, problem, P, E, round, say);
      continue
    end
    break
  end
end

function state = oneRound (state, problem, P, E, round, say)
  state = runAndFit (state, problem, P, 'infill', E);
  state = moveTo (state, problem);
  state = bookStep (state, problem, 'infill', round, say);
end

% The plan is run at the cheapest level. How far the others are from it is best
% known where it matters: at the set that the cheap runs find. A set that is run
% at two levels tells their difference alone.
function state = nestLevels (state, problem, say)
  if isempty (problem.coarse)
    return
  end
  levels = flipud (problem.coarse.levels);     % the one that counts first
  isFinished = all (isfinite (state.data.Z(:, problem.calibrate)), 2);
  isKnown = ismember (levels, state.data.E(isFinished, :), 'rows');
  E = levels(~isKnown, :);
  if ~isempty (E) && budgetLeft (state, problem) > 0
    P = repmat (state.found.params, rows (E), 1);
    state = oneRound (state, problem, P, E, 0, say);
  end
end

% Where, and at which level, the next N runs help most: P n x d, E n x v.
function [P, E] = chooseInfill (state, problem, n, round)
  name = problem.options.infill;
  propose = str2func (['infill', upper(name(1)), name(2:end)]);
  if isempty (problem.coarse)
    P = toAllowed (propose (state, problem, n, round), problem);
    E = zeros (rows (P), 0);
  else
    P = toAllowed (propose (state, problem, max (n, 5), round), problem);
    [P, E] = chooseLevels (state.surrogates, problem, unique (P, 'rows'), n, ...
                           pricesOf (state, problem));
  end
end

% Coarse runs are out of reach where enough has been spent on them.
function seconds = pricesOf (state, problem)
  [~, ~, seconds] = budgetLeft (state, problem);
  if isempty (seconds)
    seconds = ones (1, rows (problem.coarse.levels));
    return
  end
  [~, level] = ismember (state.data.E, problem.coarse.levels, 'rows');
  spent = accumarray (level(level > 0), 1, [numel(seconds), 1])' .* seconds;
  if sum (spent(1:end - 1)) >= spent(end)
    seconds(1:end - 1) = Inf;
  end
end

% Set, of the likely ones Q, and level of the next N runs. Gain of a run: what
% it takes off the variance of the responses at the level that counts, in
% tolerances, as a mean over the sets Q, per core-second. One after the other,
% each after the ones before it. A dropped level tells a surrogate nothing.
function [P, E] = chooseLevels (surrogates, problem, Q, n, seconds)
  k = rows (Q);
  levels = problem.coarse.levels;
  L = rows (levels);
  P = repmat (Q, L, 1);                       % candidates, level by level
  E = levels(kron ((1:L)', ones (k, 1)), :);
  cost = kron (seconds(:), ones (k, 1));
  parts = [];
  for t = find (problem.calibrate)
    parts = [parts, covariances(surrogates(t), problem, t, Q, P, E)];
  end
  chosen = zeros (n, 1);
  for i = 1:n
    gain = zeros (k * L, 1);
    for part = parts
      variance = diag (part.S);
      gain = gain + sumsq (part.S(1:k, k + 1:end), 1)' ./ ...
                    (variance(k + 1:end) + part.noise);
    end
    [~, chosen(i)] = max (gain ./ cost);
    for j = 1:numel (parts)
      s = parts(j).S(:, k + chosen(i));
      parts(j).S = parts(j).S - s * s' / (s(k + chosen(i)) + ...
                                          parts(j).noise(chosen(i)));
    end
  end
  P = P(chosen, :);
  E = E(chosen, :);
end

% Posterior covariance of response t at the sets Q at the level that counts and
% at the candidates, and the noise of a run there, in tolerances.
function part = covariances (s, problem, t, Q, X, E)
  k = rows (Q);
  level = unitLevel (problem.coarse, E, t);
  inputs = [Q; X];
  if ~isempty (s.extra)
    inputs(:, end + 1) = [zeros(k, 1); level];
  end
  [m, ~, S, noise] = krigingPosterior (s, inputs);
  S = s.factor * S;
  lost = k + find (ismember (level, s.dropped));
  S(lost, :) = 0;
  S(:, lost) = 0;
  Z = repmat (problem.value, k, 1);
  Z(:, t) = s.shift + s.scale * m(1:k);
  [~, slope] = targetResidual (problem, Q, Z);
  unit = mean (abs (slope(:, t))) / problem.part(t) * s.scale;
  part = struct ('S', S * unit^2, 'noise', noise(k + 1:end) * unit^2);
end

%!test
%! % nothing to spend: said; a set out of reach: said, with few runs
%! [problem, state, s] = smallCalibration ();
%! state.found.probability = 0;
%! out = state;
%! out.evaluate = @(varargin) error ('run');
%! [out.budget.left, out.budget.isUsedUp] = deal (0, true);
%! out = improveByInfill (out, problem, @(x) []);
%! assert (out.reason, 'no runs left for infill');
%! problem.value(2) = 9;
%! state.found = calibrateOnKriging (s, problem);
%! out = improveByInfill (state, problem, @(x) []);
%! assert (strncmp (out.reason, 'no set meets: y', 15));
%! assert (sum (isAfterPlan (out.data)) < 10);

%!function [problem, state, f] = levelled (levels, X, E)
%!  C = struct ('names', {{'a', 'b'}}, 'limits', [0, 0; 1, 1], ...
%!              'targets', struct ('value', {2, 0.1}, 'tol', 0.01, ...
%!                                 'model', 1));
%!  C.coarse = struct ('variable', 'scaleP', 'levels', levels, 'models', 1);
%!  C.options.likely = 1.1;
%!  problem = newProblem (C, []);
%!  f = @(P, E, r) [1 + sum(P, 2), P(:, 1) - P(:, 2)] + 0.1 * (E - 1);
%!  Z = f (X, E, 1) + 0.005 * randn (rows (X), 2);
%!  data = addRows (newData (2, 2, 1), X, Z, ones (rows (X), 1), 'plan', E);
%!  s = fitSurrogates (data, problem);
%!  state = newState (data, s, describeSet (s, problem, [0.55, 0.45]));
%!  state.found.conflict = {};
%!endfunction

%!test
%! % one run at each level that has none, at the set that the coarse runs find
%! rand ('twister', 4);
%! randn ('twister', 4);
%! [problem, state, f] = levelled ([3, 2, 1], rand (7, 2), 3 * ones (7, 1));
%! problem.options.maxFunEvals = 2;
%! state.evaluate = newEvaluate (f);
%! nested = improveByInfill (state, problem, @(text) []);
%! assert (nested.data.E(8:end), [1; 2]);
%! assert (nested.data.X(8:end, :), repmat (state.found.params, 2, 1));
%! assert (nested.data.stage(8:end), {'infill'; 'infill'});
%! again = improveByInfill (nested, problem, @(text) []);
%! assert ([rows(again.data.X), numel(again.history)], [9, 1]);

%!function E = nextLevels (seconds, n, state, problem)
%!  state.budget.levels = [2, seconds(1); 1, seconds(2)];
%!  state.evaluate = @(P, E, varargin) error ('%d ', E);
%!  problem.options.sets = n;
%!  E = [];
%!  try
%!    improveByInfill (state, problem, @(text) []);
%!  catch err
%!    E = sscanf (err.message, '%d')';
%!  end
%!endfunction

%!test
%! % where coarse runs cost almost nothing they are made, where they cost as
%! % much as the others, or have cost as much as those in all, they are not
%! rand ('twister', 4);
%! randn ('twister', 4);
%! [problem, state] = levelled ([2, 1], [rand(8, 2); 0.5, 0.5], ...
%!                              [2 * ones(8, 1); 1]);
%! assert (nextLevels ([1e-6, 1], 3, state, problem), [2, 2, 2]);
%! assert (nextLevels ([1, 1], 2, state, problem), [1, 1]);
%! assert (nextLevels ([0.2, 1], 2, state, problem), [1, 1]);
%! % a dropped level is never taken, whatever it costs
%! [state.surrogates.dropped] = deal (1);
%! assert (nextLevels ([1e-9, 1], 2, state, problem), [1, 1]);

% SPDX-License-Identifier: GPL-3.0-only
