% FITHYPOTHESIS  Fits parameters and strengths to many data sets at once.
%
% CALL: FIT = fitHypothesis (WHITE, H, Z, Q, BOX)
%
%   WHITE  struct of whitenEmulator
%   H      1 x h, numbers of the active effects
%   Z      n x T, whitened data sets, one a row
%   Q      n x (p + h), start of each
%   BOX    struct of hypothesisBox
%   FIT    struct
%     Q (n x (p + h)), cost (n x 1): minus log posterior density without
%       constants, half of sum (r^2 / v + log v) + prior
%     chi2 (n x 1): sum (r^2 / v), A (n x d x d): Gauss-Newton matrix with prior
%
% Levenberg-Marquardt with projection on the box, vectorised over the rows. The
% logarithm of the variance is part of the cost, so that no fit flees to where
% the surrogate is vague.
%
% See also: predictGap, integrateEvidence

function fit = fitHypothesis (white, h, Z, Q, box)
  n = rows (Q);
  damping = 0.01 * ones (n, 1);
  [cost, chi2] = costOf (white, h, Z, Q, box);
  active = true (n, 1);
  for iteration = 1:12
    at = find (active);
    if isempty (at)
      break
    end
    [A, g] = normalEquations (white, h, Z(at, :), Q(at, :), box);
    tried = stepFrom (A, g, Q(at, :), damping(at), box);
    [newCost, newChi2] = costOf (white, h, Z(at, :), tried, box);
    gain = cost(at) - newCost;
    better = gain > 0;
    Q(at(better), :) = tried(better, :);
    cost(at(better)) = newCost(better);
    chi2(at(better)) = newChi2(better);
    damping(at) = damping(at) .* (0.2 * better + 10 * ~better);
    active(at) = (~better & damping(at) < 1e3) | gain > 0.005;
  end
  fit = struct ('Q', Q, 'cost', cost, 'chi2', chi2);
  fit.A = normalEquations (white, h, Z, Q, box);
end

function [cost, chi2] = costOf (white, h, Z, Q, box)
  [M, V] = predictGap (white, h, Q);
  chi2 = sum ((Z - M).^2 ./ V, 2);
  cost = 0.5 * (chi2 + sum (log (V), 2)) + ...
         0.5 * sum (box.precision .* (Q - box.mean).^2, 2);
end

function [A, g] = normalEquations (white, h, Z, Q, box)
  [M, V, J] = predictGap (white, h, Q);
  d = columns (Q);
  R = (Z - M) ./ V;
  A = zeros (rows (Q), d, d);
  g = zeros (rows (Q), d);
  for a = 1:d
    g(:, a) = sum (J{a} .* R, 2) - ...
              box.precision(a) * (Q(:, a) - box.mean(a));
    weighted = J{a} ./ V;
    for b = 1:a
      A(:, a, b) = sum (weighted .* J{b}, 2);
      A(:, b, a) = A(:, a, b);
    end
    A(:, a, a) = A(:, a, a) + box.precision(a);
  end
end

% A coordinate at its limit whose gradient points outwards stays there.
function Q = stepFrom (A, g, Q, damping, box)
  d = columns (Q);
  stuck = (Q <= box.lo & g < 0) | (Q >= box.hi & g > 0);
  g(stuck) = 0;
  for a = 1:d
    A(:, a, a) = A(:, a, a) .* (1 + damping) + damping + 1e-9;
  end
  for a = 1:d
    for b = 1:d
      if a ~= b
        A(:, a, b) = A(:, a, b) .* ~(stuck(:, a) | stuck(:, b));
      end
    end
  end
  Q = min (max (Q + solveMany (A, g), box.lo), box.hi);
end

%!test
%! % straight line, unit variance: least squares, cut to the box
%! white = struct ('p', 1, 'powers', [0; 1], 'coef', [0, 1; 2, 1], ...
%!                 'varPowers', 0, 'varCoef', [0, 0], 'effect', []);
%! prior = struct ('mean', 0, 'precision', 0, 'widen', 1);
%! box = hypothesisBox (white, [], prior);
%! fit = fitHypothesis (white, [], [1, 1.5; 9, 9], [0; 0], box);
%! assert (fit.Q, [0.5; 1], 1e-4);
%! assert (fit.chi2(1), 0, 1e-6);
%! assert (squeeze (fit.A(1, 1, 1)), 5, 1e-12);
