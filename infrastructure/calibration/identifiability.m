% IDENTIFIABILITY  What the targets cannot fix, and what would fix it best.
%
% CALL: WEAK = identifiability (SURROGATES, PROBLEM, KNOWN)
%
% SURROGATES  1 x T struct array of fitSurrogates
% PROBLEM     struct of newProblem
% KNOWN       struct of parameterPosterior
% WEAK        struct: notIdentified (cellstr of parameters whose 90 % interval
%             is wider than half of the box), directions d x k (unit vectors in
%             the unit box along which the posterior keeps more than half of
%             the prior's standard deviation), text (cellstr, the directions in
%             words), next (struct array, best first: kind 'held-out target',
%             'measure' (a target that is not measured yet) or
%             'measure directly', name, gain (share of the total relative
%             variance of the parameters that it is expected to take away))
%
% The gains follow from the covariances of the posterior sample (linear
% Bayes): measuring y with variance s2 takes cov (p, y)^2 / (var (y) + s2) off
% the variance of p. A direct measurement is taken to be good to 5 % of the box.

function weak = identifiability (surrogates, problem, known)
  U = (known.sample - problem.limits(1, :)) ./ diff (problem.limits);
  weak.notIdentified = problem.names(~known.identified);
  [V, D] = eig (cov (U));
  loose = sqrt (diag (D)) > problem.options.loose / sqrt (12);
  weak.directions = fliplr (V(:, loose));
  weak.text = cell (1, columns (weak.directions));
  for k = 1:columns (weak.directions)
    weak.text{k} = inWords (weak.directions(:, k), problem.names);
  end
  weak.next = furtherTargets (surrogates, problem, known.sample, U);
end

function text = inWords (v, names)
  v = v / max (abs (v));
  [~, order] = sort (abs (v), 'descend');
  order = order(abs (v(order)) > 0.3);
  v = v * sign (v(order(1)));
  parts = cell (1, numel (order));
  for i = 1:numel (order)
    parts{i} = sprintf ('%+.1f %s', v(order(i)), names{order(i)});
  end
  text = [strjoin(parts, ' '), ' (in box widths)'];
end

function next = furtherTargets (surrogates, problem, sample, U)
  next = struct ('kind', {}, 'name', {}, 'gain', {});
  for t = find (~problem.calibrate)
    [m, v] = predictSurrogate (surrogates(t), sample);
    s2 = mean (v) + surrogates(t).noiseVar + problem.sd(t)^2;
    kind = 'held-out target';
    if isnan (problem.value(t))
      kind = 'measure';
    end
    next(end + 1) = struct ('kind', kind, ...
                            'name', surrogates(t).name, ...
                            'gain', gainOf (U, m, s2));
  end
  for j = 1:columns (U)
    next(end + 1) = struct ('kind', 'measure directly', ...
                            'name', problem.names{j}, ...
                            'gain', gainOf (U, U(:, j), ...
                                            problem.options.direct^2));
  end
  [~, order] = sort ([next.gain], 'descend');
  next = next(order);
end

function gain = gainOf (U, y, s2)
  c = (U - mean (U, 1))' * (y - mean (y)) / (rows (U) - 1);
  gain = sum (c.^2) / (var (y) + s2) / sum (var (U, 0, 1));
end

%!test
%! % y = a + b fixes the sum, not the difference; c is not fixed at all
%! pkg load stk
%! rand ('twister', 1);
%! randn ('twister', 1);
%! C = struct ('names', {{'a', 'b', 'c'}}, 'limits', [0, 0, 0; 1, 1, 1], ...
%!             'targets', struct ('value', 1, 'tol', 0.01));
%! problem = newProblem (C, []);
%! X = rand (20, 3);
%! s = fitSurrogate (X, X(:, 1) + X(:, 2) + 0.02 * randn (20, 1), C.limits);
%! known = parameterPosterior (s, problem);
%! weak = identifiability (s, problem, known);
%! assert (any (strcmp (weak.notIdentified, 'c')));
%! assert (columns (weak.directions), 2);
%! assert (sum (weak.directions(1:2, :), 1), [0, 0], 0.35);
%! assert (numel (weak.next), 3);
%! assert (weak.next(1).gain > 0.2);
