% SURESTSET  The set that most probably meets all targets; what is open by preference.
%
% CALL: [P, USED] = surestSet (SURROGATES, PROBLEM, POOL)
%
% POOL  k x d  sets to start from, best first; may be empty
% P     1 x d
%
% Starts: the least sums of (r^2 + s^2) / tolerance^2 (residualSpread) among the
% pool, the centroid of the runs and a space-filling sample, the best two
% brought to their local least; then a shrinking search for the largest
% probability.
%
% Where the cost function has rows beside the targets, or parameters were
% measured by themselves, they choose among what the data leave open (preferredSet,
% which says what USED is; []: nothing is preferred).

function [p, used] = surestSet (surrogates, problem, pool)
  [p, best] = mostProbable (surrogates, problem, pool);
  if ~isempty (pool)
    known = meetProbability (surrogates, problem, pool(1, :));
    if best < known
      [p, best] = deal (pool(1, :), known);
    end
  end
  used = [];
  isPreferred = problem.nExtra > 0 || any (isfinite (problem.paramSd));
  if isPreferred && best >= problem.options.even
    [p, used] = preferredSet (surrogates, problem, p);
  end
end

function [p, probability] = mostProbable (surrogates, problem, pool)
  d = columns (problem.limits);
  sample = sampleBox (300, problem.limits);
  centroid = insideLimits (mean (surrogates(1).X, 1), problem.limits);
  P = toAllowed ([pool; centroid; sample], problem);
  [~, order] = sort (sum (loss (surrogates, problem, P).^2, 2));
  P = P(order(1:10), :);
  settings = optimset ('MaxIter', 20, 'TolFun', 1e-2);
  for k = 1:2
    [f, J] = residualHandles (surrogates, problem, true);
    P(k, :) = leastSquaresInBox (f, J, P(k, :), problem, settings);
  end
  step = double (stk_sampling_halton_rr2 (30, d, [-ones(1, d); ones(1, d)]));
  for radius = 0.3 * 0.75.^(0:15)
    [~, order] = sort (meetProbability (surrogates, problem, P), 'descend');
    best = P(order(1:3), :);
    P = best;
    for k = 1:3
      P = [P; setsAround(best(k, :), radius * circshift (step, k, 2), ...
                         problem)];
    end
    step = -circshift (step, 1, 2);
  end
  [probability, share] = meetProbability (surrogates, problem, best);
  [~, order] = sortrows ([-round(probability * 1e6), sum(share.^2, 2)]);
  p = best(order(1), :);
  probability = probability(order(1));
end

function f = loss (surrogates, problem, P)
  [r, s] = residualSpread (surrogates, problem, P);
  use = problem.calibrate;
  f = [r(:, use) ./ problem.part(use), s(:, use) ./ problem.part(use)];
end

%!shared problem, s
%! [problem, ~, s] = smallCalibration ();
%!test
%! p = surestSet (s, problem, zeros (0, 2));
%! r = residualSpread (s, problem, p);
%! assert (all (abs (r) < 0.02));
%! assert (meetProbability (s, problem, p) > 0.5);
%!test
%! % a third parameter that matters to nobody goes where it is preferred
%! problem.calibrate(2) = false;
%! p = surestSet (s, problem, zeros (0, 2));
%! problem.cost = @(p, f) [f(p) ./ [4; 2] - 1; 2 - p(2)];
%! problem.nExtra = 1;
%! q = surestSet (s, problem, zeros (0, 2));
%! assert (q(2) >= p(2));
%! assert (meetProbability (s, problem, q) >= ...
%!         meetProbability (s, problem, p) - 0.021);
%! % measured by itself: of the sets that are as sure the nearest is taken
%! problem.nExtra = 0;
%! problem.paramMean = [0.2, NaN];
%! problem.paramSd = [0.05, NaN];
%! q = surestSet (s, problem, zeros (0, 2));
%! assert (abs (q(1) - 0.2) <= abs (p(1) - 0.2));

% SPDX-License-Identifier: GPL-3.0-only
