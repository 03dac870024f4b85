% CHOOSEINFILL  Where, and at which level, the next DEM runs help most.
%
% CALL: [P, E] = chooseInfill (STATE, PROBLEM, N, ROUND)
%
% STATE    struct of newState
% PROBLEM  struct of newProblem
% N        number of runs that can go at once
% ROUND    integer, makes the draws of each round their own
% P        n x d
% E        n x v, levels of the runs
%
% The sets are those of the criterion: options.infill of PROBLEM, 'thompson' for
% infillThompson; each is a file of its own with that call. Where there are
% levels, those of five such sets are taken that gain most per core-second.
% Coarse runs cost at most as much as the runs at the level that counts have
% cost: however sure the coarse ones make the surrogates, they are held against
% fine ones in time, and a level that misleads costs no more than it would save.

function [P, E] = chooseInfill (state, problem, n, round)
  name = problem.options.infill;
  propose = str2func (['infill', upper(name(1)), name(2:end)]);
  if isempty (problem.coarse)
    P = propose (state, problem, n, round);
    E = zeros (rows (P), 0);
  else
    P = propose (state, problem, max (n, 5), round);
    [P, E] = chooseLevels (state.surrogates, problem, unique (P, 'rows'), n, ...
                           pricesOf (state, problem));
  end
end

% Coarse runs are out of reach where enough has been spent on them.
function seconds = pricesOf (state, problem)
  [~, ~, seconds] = budgetLeft (state, problem);
  if isempty (seconds)
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
  if isempty (seconds)
    seconds = ones (1, L);
  end
  P = repmat (Q, L, 1);                       % candidates, level by level
  E = levels(kron ((1:L)', ones (k, 1)), :);
  cost = kron (seconds(:), ones (k, 1));
  parts = {};
  for t = find (problem.calibrate)
    parts{end + 1} = covariances (surrogates(t), problem, t, Q, P, E);
  end
  chosen = zeros (n, 1);
  for i = 1:n
    gain = zeros (k * L, 1);
    for j = 1:numel (parts)
      variance = diag (parts{j}.S);
      gain = gain + sumsq (parts{j}.S(1:k, k + 1:end), 1)' ./ ...
                    (variance(k + 1:end) + parts{j}.noise);
    end
    [~, chosen(i)] = max (gain ./ cost);
    for j = 1:numel (parts)
      parts{j} = conditioned (parts{j}, k + chosen(i), ...
                              parts{j}.noise(chosen(i)));
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
  if ~isempty (s.level)
    inputs(:, end + 1) = [zeros(k, 1); level];
  end
  [S, m] = posteriorCovariance (s, inputs);
  S = s.factor * S;
  lost = k + find (ismember (level, s.dropped));
  S(lost, :) = 0;
  S(:, lost) = 0;
  noise = noiseAt (s, level) / s.scale^2;
  Z = repmat (problem.value, k, 1);
  Z(:, t) = s.shift + s.scale * m(1:k);
  [~, slope] = targetResidual (problem, Q, Z);
  unit = mean (abs (slope(:, t))) / problem.part(t) * s.scale;
  part = struct ('S', S * unit^2, 'noise', noise * unit^2);
end

function part = conditioned (part, i, noise)
  s = part.S(:, i);
  part.S = part.S - s * s' / (s(i) + noise);
end

%!shared problem, state
%! pkg load stk
%! rand ('twister', 4);
%! randn ('twister', 4);
%! C = struct ('names', {{'a', 'b'}}, 'limits', [0, 0; 1, 1], ...
%!             'targets', struct ('value', 2, 'tol', 0.01, 'model', 1));
%! C.coarse = struct ('variable', 'scaleP', 'levels', [2, 1], 'models', 1);
%! problem = newProblem (C, []);
%! X = [rand(8, 2); 0.5, 0.5];
%! E = [2 * ones(8, 1); 1];
%! Z = 1 + X(:, 1) + X(:, 2) + 0.3 * (E - 1) + 0.005 * randn (9, 1);
%! data = addRows (newData (2, 1, 1), X, Z, ones (9, 1), 'plan', E);
%! state = newState (data, fitSurrogates (data, problem), ...
%!                   struct ('params', [0.5, 0.5], 'probability', 0));

%!function E = levelsAt (seconds, n, state, problem)
%!  state.budget.levels = [2, seconds(1); 1, seconds(2)];
%!  [P, E] = chooseInfill (state, problem, n, 1);
%!  assert (size (P), [n, 2]);
%!endfunction
%!test
%! % where coarse runs cost almost nothing they are made, where they cost as
%! % much as the others, or have cost as much as those in all, they are not
%! assert (levelsAt ([1e-6, 1], 3, state, problem), [2; 2; 2]);
%! assert (levelsAt ([1, 1], 2, state, problem), [1; 1]);
%! assert (levelsAt ([0.2, 1], 2, state, problem), [1; 1]);
%! % a dropped level is never taken, whatever it costs
%! state.surrogates.dropped = 1;
%! assert (levelsAt ([1e-9, 1], 2, state, problem), [1; 1]);
