% MOSTPROBABLESET  The set that most probably meets all targets.
%
% CALL: [P, PROBABILITY] = mostProbableSet (SURROGATES, PROBLEM, POOL)
%
% POOL         k x d  sets to start from, best first (may be empty)
% P            1 x d
% PROBABILITY  Pr(all targets truly met at p), see meetProbability
%
% Starts: the least sums of (r^2 + s^2) / tolerance^2 (r residual of the
% surrogate mean, s its standard deviation) among the pool, the centroid of the
% runs and a space-filling sample, each brought to its local least by
% nonlin_residmin; then a shrinking search for the largest probability. Of all
% sets that meet the targets this is the one of which the surrogates know most.

function [p, probability] = mostProbableSet (surrogates, problem, pool)
  d = columns (problem.limits);
  sample = double (stk_sampling_halton_rr2 (300, d, problem.limits));
  centroid = insideLimits (mean (surrogates(1).X, 1), problem.limits);
  P = [pool; centroid; sample];
  [~, order] = sort (sum (loss (surrogates, problem, P).^2, 2));
  P = P(order(1:10), :);
  for k = 1:2
    P(k, :) = descend (surrogates, problem, P(k, :));
  end
  step = double (stk_sampling_halton_rr2 (30, d, [-ones(1, d); ones(1, d)]));
  for radius = 0.3 * 0.75.^(0:15)
    [~, order] = sort (meetProbability (surrogates, problem, P), 'descend');
    best = P(order(1:3), :);
    P = best;
    for k = 1:3
      P = [P; setsAround(best(k, :), radius * circshift (step, k, 2), ...
                         problem.limits)];
    end
    step = -circshift (step, 1, 2);
  end
  [probability, r] = meetProbability (surrogates, problem, best);
  norm2 = sum (toleranceShare (problem, r).^2, 2);
  [~, order] = sortrows ([-round(probability * 1e6), norm2]);
  p = best(order(1), :);
  probability = probability(order(1));
end

function p = descend (surrogates, problem, p)
  lo = problem.limits(1, :);
  width = problem.limits(2, :) - lo;
  f = @(u) loss (surrogates, problem, lo + u(:)' .* width)';
  J = @(u, hook) slope (surrogates, problem, lo + u(:)' .* width);
  u = leastSquaresInBox (f, J, min (max ((p - lo) ./ width, 0), 1)', ...
                         optimset ('MaxIter', 20, 'TolFun', 1e-2));
  p = lo + u' .* width;
end

function f = loss (surrogates, problem, P)
  [r, s] = residualSpread (surrogates, problem, P);
  use = problem.calibrate;
  f = [r(:, use) ./ problem.part(use), s(:, use) ./ problem.part(use)];
end

function J = slope (surrogates, problem, p)
  [J, G] = surrogateJacobian (surrogates, problem, p);
  J = [J; G];
end

%!shared problem, state, s
%! [problem, state, s] = smallCalibration ();

%!test
%! [p, probability] = mostProbableSet (s, problem, zeros (0, 2));
%! r = targetResidual (problem, p, predictSurrogate (s, p));
%! assert (all (abs (r) < 0.02));
%! assert (probability, meetProbability (s, problem, p), 1e-12);
%! assert (probability > 0.5);
