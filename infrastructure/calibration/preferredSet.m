% PREFERREDSET  Breaks ties among sure sets by the preference of the user.
%
% CALL: P = preferredSet (SURROGATES, PROBLEM, P, POOL)
%
% P     1 x d  surest set
% POOL  k x d  other sets that were found
%
% Looks, around p and the pool, for the least preference value among sets whose
% probability of meeting all targets is at most options.better below that of p
% and at least options.even. A set that does not meet the targets is never
% preferred.

function p = preferredSet (surrogates, problem, p, pool)
  best = meetProbability (surrogates, problem, p);
  if best < problem.options.even
    return
  end
  loss = @(P) preferenceIfSure (P, surrogates, problem, best);
  p = shrinkingSearch (loss, p, [0.2, 0.1, 0.05, 0.05, 0.02, 0.02], 200, ...
                       problem.limits, pool);
end

% Inf for a set that is less sure than the best one.
function value = preferenceIfSure (P, surrogates, problem, best)
  value = Inf (rows (P), 1);
  sure = meetProbability (surrogates, problem, P) >= ...
         max (problem.options.even, best - problem.options.better);
  if any (sure)
    value(sure) = preferenceOf (problem, P(sure, :));
  end
end

% What speaks against a set beside its targets: the sum of squares of the rows
% below the targets (the Rayleigh term) and of the distances to parameters that
% were measured by themselves, in their standard deviations.
function value = preferenceOf (problem, P)
  z = (P - problem.paramMean) ./ problem.paramSd;
  value = sumsq (z(:, isfinite (problem.paramSd)), 2);
  if problem.nExtra == 0
    return
  end
  T = numel (problem.value);
  for i = 1:size (P, 1)
    r = problem.cost (P(i, :)', @(varargin) problem.value(:));
    value(i) = value(i) + sum (r(T + 1:end).^2);
  end
end

%!shared problem, state, s
%! [problem, state, s] = smallCalibration ();

%!test
%! % a third parameter that matters to nobody goes where it is preferred
%! problem.calibrate(2) = false;
%! problem.cost = @(p, f) [f(p) ./ [4; 2] - 1; 2 - p(2)];
%! problem.nExtra = 1;
%! p = mostProbableSet (s, problem, zeros (0, 2));
%! q = preferredSet (s, problem, p, zeros (0, 2));
%! assert (q(2) >= p(2));
%! assert (meetProbability (s, problem, q) >= ...
%!         meetProbability (s, problem, p) - 0.021);

%!test
%! % measured by itself: of the sets that are as sure the nearest is taken
%! problem.calibrate(2) = false;
%! problem.paramMean = [0.2, NaN];
%! problem.paramSd = [0.05, NaN];
%! p = mostProbableSet (s, problem, zeros (0, 2));
%! q = preferredSet (s, problem, p, zeros (0, 2));
%! assert (abs (q(1) - 0.2) <= abs (p(1) - 0.2));
