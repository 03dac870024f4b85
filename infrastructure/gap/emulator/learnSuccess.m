% LEARNSUCCESS  Learns where a bench gives a result at all.
%
% CALL: [BASE, OWN] = learnSuccess (BENCH, THETA, PHI, Z)
%
%   BENCH  1 x T, bench of each target
%   THETA  n x p, runs: parameters in [-1, 1];  PHI  n x K, strengths
%   Z      n x T, results, NaN = no result, NA = not run
%   BASE   (1 + p) x B, logistic regression of success on 1 and the parameters;
%          zeros where no run of the bench has failed
%   OWN    1 x K cell of 2 x B, the same on |phi| and phi of each effect
%
% That a slot jams is a result: where the measurement went through, strengths at
% which the model jams are unlikely. Maximum posterior with coefficients N (0,
% 3^2) by Newton's method; the intercept is free. Strengths count threefold, so
% that within its range an effect may lead from sure to impossible.

function [base, own] = learnSuccess (bench, theta, phi, Z)
  p = columns (theta);
  K = columns (phi);
  F = [ones(rows (theta), 1), theta, 3 * abs(phi), 3 * phi];
  B = max (bench);
  coef = zeros (columns (F), B);
  for b = 1:B
    own = Z(:, bench == b);
    isRun = ~any (isna (own), 2);
    none = all (isnan (own), 2) & isRun;
    if any (none) && any (isRun & ~none)
      coef(:, b) = logistic (F(isRun, :), ~none(isRun));
    end
  end
  base = coef(1:p + 1, :);
  own = cell (1, K);
  for k = 1:K
    own{k} = 3 * coef(p + 1 + [k, K + k], :);
  end
end

function coef = logistic (F, yes)
  precision = [1e-4; ones(columns (F) - 1, 1)] / 9;
  share = mean (yes);
  coef = [log(share / (1 - share)); zeros(columns (F) - 1, 1)];
  for step = 1:50
    p = 1 ./ (1 + exp (-F * coef));
    g = F' * (yes - p) - precision .* coef;
    H = F' * (max (p .* (1 - p), 1e-6) .* F) + diag (precision);
    move = H \ g;
    move = move / max (1, norm (move) / 4);
    coef = coef + move;
    if norm (move) < 1e-6
      return
    end
  end
end

%!test
%! % jams where the effect is strong, never without (seeded)
%! rand ('twister', 1);
%! theta = 2 * rand (80, 1) - 1;
%! phi = [zeros(40, 1); rand(40, 1)];
%! Z = ones (80, 3);
%! Z(phi > 0.6, 3) = NaN;
%! [base, own] = learnSuccess ([1, 1, 2], theta, phi, Z);
%! assert (base(:, 1), [0; 0]);
%! p = @(phi) 1 / (1 + exp (-base(1, 2) - [phi, phi] * own{1}(:, 2)));
%! assert ([p(0), p(0.1)] > [0.95, 0.9]);
%! assert (p(1) < 0.2);
