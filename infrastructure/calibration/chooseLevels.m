% CHOOSELEVELS  Set and level of the next runs: most gain per core-second.
%
% CALL: [P, E] = chooseLevels (SURROGATES, PROBLEM, Q, N, SECONDS)
%
%   SURROGATES  1 x T struct array of fitSurrogates
%   PROBLEM     struct of newProblem with coarse
%   Q           k x d, likely sets
%   N           number of runs
%   SECONDS     1 x L, what a run costs at each level; []: not known, all alike
%   P, E        N x d and N x v, sets of Q and the levels to run them at
%
% Gain of a run: what it takes off the variance of the responses at the level
% that counts, in tolerances, as a mean over the sets Q. One after the other,
% each after the ones before it. A level that a surrogate has dropped tells it
% nothing.
%
% See also: chooseInfill, fitLevels, levelSeconds

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
      own = diag (parts{j}.S);
      gain = gain + sumsq (parts{j}.S(1:k, k + 1:end), 1)' ./ ...
                    (own(k + 1:end) + parts{j}.noise);
    end
    [~, chosen(i)] = max (gain ./ cost);
    for j = 1:numel (parts)
      parts{j} = told (parts{j}, k + chosen(i), parts{j}.noise(chosen(i)));
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
  at = [Q; X];
  if ~isempty (s.level)
    at(:, end + 1) = [zeros(k, 1); level];
  end
  [S, m] = posteriorCovariance (s, at);
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

function part = told (part, i, noise)
  s = part.S(:, i);
  part.S = part.S - s * s' / (s(i) + noise);
end

%!shared problem, s, Q, E
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
%! s = fitSurrogates (data, problem);
%! Q = [0.4, 0.6; 0.9, 0.1];

%!test
%! % where coarse runs cost almost nothing they are made, where they cost as
%! % much as the others they are not
%! [P, E] = chooseLevels (s, problem, Q, 3, [0.001, 1]);
%! assert (E, [2; 2; 2]);
%! assert (all (ismember (P, Q, 'rows')));
%! [~, E] = chooseLevels (s, problem, Q, 2, [1, 1]);
%! assert (E, [1; 1]);

%!test
%! % a dropped level is never taken, whatever it costs
%! s.dropped = 1;
%! [~, E] = chooseLevels (s, problem, Q, 2, [1e-9, 1]);
%! assert (E, [1; 1]);
