% DISCREPANCYKINDS  Describes misfits that resemble no listed effect.
%
% CALL: KINDS = discrepancyKinds (PROBLEM, EMULATOR, BUDGET, TARGETS)
%
%   PROBLEM, EMULATOR, BUDGET     of newProblem, fitEmulator, noiseBudget
%   TARGETS  1 x n, targets to look at
%   KINDS  1 x m struct: name, weight (sum 1), h (newHypothesis), white
%          (of whitenEmulator, turned so that the misfit has independent
%          coordinates, with shape: 1 x n, its variances at size 1)
%
% y = m (theta) + delta + noise, delta ~ N (0, size^2 C), size log-normal. C is
% (half of the weight) shaped like the listed effects, since an unknown cause
% moves the targets that causes move: 0.7 mean (s s') + 0.3 diag, s their
% signatures; or independent errors on all targets; or on one bench alone. After
% Kennedy and O'Hagan (2001).

function kinds = discrepancyKinds (problem, emulator, budget, targets)
  benches = unique (problem.bench(targets));
  R = diag (emulator.range(targets).^2);
  S = middleMarks (emulator, targets);
  % a misfit has no effects
  emulator = withoutEffects (emulator);
  % not turned: what turns them starts from here
  white = whitenEmulator (emulator, targets, budget);
  make = @(C, extent, name, weight) ...
    oneKind (emulator, white, budget, C, ...
             struct ('name', name, 'weight', weight, ...
                     'h', newHypothesis ('discrepancy', zeros (1, 0), extent)));
  % 0.08 of the range of a target, a factor of e up or down
  kinds = make (R, [0.08, 1], 'anything', 0.2);
  for b = benches
    % what is wrong with a rig is wrong with its own readings only
    mask = diag (problem.bench(targets) == b);
    kinds(end + 1) = make (R .* mask, [0.08, 1], problem.benchNames{b}, ...
                           0.3 / numel (benches));
  end
  if rows (S) > 0
    C = 0.7 * (S' * S) / rows (S) + 0.3 * diag (mean (S.^2, 1));
    kinds(end + 1) = make (C, [0.7, 0.8], 'effect', 0.5);
  end
  total = sum ([kinds.weight]);
  for k = 1:numel (kinds)
    kinds(k).weight = kinds(k).weight / total;
  end
end

function kind = oneKind (emulator, white, budget, C, kind)
  isTarget = white.isTarget > 0;
  C = white.W(isTarget, :) * C * white.W(isTarget, :)';
  % turned so that the misfit has independent coordinates, as the likelihood takes
  % them
  [U, L] = eig ((C + C') / 2);
  kind.white = whitenEmulator (emulator, white.columns, budget, U');
  kind.white.shape = zeros (size (isTarget));
  kind.white.shape(isTarget) = max (diag (L)', 0);
end

%!test
%! % rotated coordinates: noise stays white, the discrepancy is diagonal
%! emulator = handMadeEmulator ([1, 2, 3; 1, 0, 2]);
%! emulator.range = [1, 2, 3];
%! problem = newProblem (struct ('value', [1, 2, 3], 'sd', [1, 1, 1], ...
%!                                     'limits', [0; 1], 'bench', [1, 1, 2]));
%! budget = struct ('covariance', eye (3), 'doubt', zeros (2, 3), ...
%!                     'estimated', [0, 0, 0], ...
%!                 'unknown', [0, 0, 0]);
%! kinds = discrepancyKinds (problem, emulator, budget, 1:3);
%! assert (numel (kinds), 3);
%! assert (sum ([kinds.weight]), 1, 1e-12);
%! W = kinds(1).white.W;
%! assert (W * W', eye (3), 1e-12);
%! assert (W * diag ([1, 4, 9]) * W', diag (kinds(1).white.shape), 1e-9);
%! assert (sum (kinds(3).white.shape > 1e-9), 1);

% SPDX-License-Identifier: GPL-3.0-only
