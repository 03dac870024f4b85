% SURESTSET  The set with the least expected squared residual.
%
% CALL: [p, probability] = surestSet (surrogates, problem, pool)
%
% pool         k x d  sets to start from, best first (may be empty)
% p            1 x d
% probability  Pr(all targets truly met at p)
%
% Minimises sum ((r^2 + s^2) / tolerance^2), the expected squared residual in
% tolerances (r residual of the surrogate mean, s its standard deviation), by
% nonlin_residmin from the best of the pool, the centroid of the runs and a
% space-filling sample: of all sets that meet the targets this is the one of
% which the surrogates know most.
%
% See also: calibrateOnKriging, meetProbability

function [p, probability] = surestSet (surrogates, problem, pool)
  lo = problem.limits(1, :);
  width = problem.limits(2, :) - lo;
  d = numel (lo);
  sample = double (stk_sampling_halton_rr2 (500, d, problem.limits));
  P = [pool; mean(surrogates(1).X, 1); sample];
  [~, order] = sort (sum (loss (surrogates, problem, P) .^ 2, 2));
  P = P(order(1:3), :);
  f = @(u) loss (surrogates, problem, lo + u(:)' .* width)';
  settings = optimset ('lbound', zeros (d, 1), 'ubound', ones (d, 1), ...
                       'dfdp', @(u, hook) slope (surrogates, problem, ...
                                                 lo + u(:)' .* width), ...
                       'MaxIter', 30, 'TolFun', 1e-3);
  for k = 1:rows (P)
    u = min (max ((P(k, :) - lo) ./ width, 0), 1)';
    u = nonlin_residmin (f, u, settings);
    P(k, :) = lo + min (max (u', 0), 1) .* width;
  end
  [probability, r] = meetProbability (surrogates, problem, P);
  key = sum (loss (surrogates, problem, P) .^ 2, 2);
  [~, best] = sortrows ([-round(probability * 1e3), key]);
  p = P(best(1), :);
  probability = probability(best(1));
end

function f = loss (surrogates, problem, P)
  [~, r, s] = meetProbability (surrogates, problem, P);
  use = problem.calibrate;
  f = [r(:, use) ./ problem.tol(use), s(:, use) ./ problem.tol(use)];
end

function J = slope (surrogates, problem, p)
  [J, G] = surrogateJacobian (surrogates, problem, p);
  J = [J; G];
end
