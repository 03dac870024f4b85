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
