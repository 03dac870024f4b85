% UNLISTEDKINDS  Describes discrepancies that no listed effect makes.
%
% CALL: KINDS = unlistedKinds (PROBLEM, EM, BUDGET, WHITE)
%
%   PROBLEM, EM, BUDGET   of newGapProblem, fitEmulator, noiseBudget
%   WHITE                 struct of whitenEmulator for the same targets
%   KINDS                 1 x m struct: name, weight (sum 1), white (whitened so
%                         that the discrepancy has independent coordinates),
%                         shape (1 x n, variances at tau = 1), tau (1 x s)
%
% y = m (theta) + delta + noise, delta ~ N (0, tau^2 C), tau log-uniform.
% C is (half of the weight) shaped like the listed effects, as an unknown cause
% moves the targets that causes move: 0.7 mean (s s') + 0.3 diag, s their
% signatures; or independent errors on all targets; or on one bench alone.
%
% See also: makeModels, weighCase

function kinds = unlistedKinds (problem, em, budget, white)
  targets = white.columns;
  benches = unique (problem.bench(targets));
  R = diag (em.range(targets).^2);
  make = @(C, name, weight) ...
    oneKind (em, white, budget.covariance, C, struct ('name', name, ...
                                                      'weight', weight));
  kinds = make (R, 'anything', 0.2);
  for b = benches
    mask = diag (problem.bench(targets) == b);
    kinds(end + 1) = make (R .* mask, problem.benchNames{b}, ...
                           0.3 / numel (benches));
  end
  S = signatures (em, targets);
  if rows (S) > 0
    C = 0.7 * (S' * S) / rows (S) + 0.3 * diag (mean (S.^2, 1));
    kinds(end + 1) = make (C, 'effect', 0.5);
    kinds(end).tau = [0.25, 0.5, 1, 2];
    kinds(end).white.extra = kinds(end).shape / 4;
  end
  total = sum ([kinds.weight]);
  for k = 1:numel (kinds)
    kinds(k).weight = kinds(k).weight / total;
  end
end

function kind = oneKind (em, white, noise, C, kind)
  C = white.W * C * white.W';
  [U, L] = eig ((C + C') / 2);
  kind.white = whitenEmulator (em, white.columns, noise, U');
  kind.shape = max (diag (L)', 0);
  kind.tau = [0.02, 0.04, 0.08, 0.16, 0.3];
  kind.white.extra = kind.shape * 0.08^2;
end

function S = signatures (em, targets)
  S = zeros (0, numel (targets));
  for k = 1:numel (em.effect)
    e = em.effect(k);
    phi = min (e.scale, e.range(2));
    B = polyRows (e.powers, [zeros(1, em.p), phi]);
    S(end + 1, :) = B * e.coef(:, targets);
  end
end

%!test
%! % rotated coordinates: noise stays white, the discrepancy is diagonal
%! em = struct ('p', 1, 'powers', [0; 1], 'coef', [1, 2, 3; 1, 0, 2], ...
%!              'varPowers', [0; 1], 'points', [-1; 0; 1], ...
%!              'surrogateVar', zeros (3, 3), 'fitVar', [0, 0, 0], ...
%!              'correlation', eye (3), 'range', [1, 2, 3]);
%! em.effect = repmat (struct ('name', ''), 1, 0);
%! problem = newGapProblem (struct ('y', [1, 2, 3], 'sd', [1, 1, 1], ...
%!                                  'limits', [0; 1], 'bench', [1, 1, 2]));
%! budget = struct ('covariance', eye (3));
%! white = whitenEmulator (em, 1:3, eye (3));
%! kinds = unlistedKinds (problem, em, budget, white);
%! assert (numel (kinds), 3);
%! assert (sum ([kinds.weight]), 1, 1e-12);
%! W = kinds(1).white.W;
%! assert (W * W', eye (3), 1e-12);
%! assert (W * diag ([1, 4, 9]) * W', diag (kinds(1).shape), 1e-9);
%! assert (sum (kinds(3).shape > 1e-9), 1);
