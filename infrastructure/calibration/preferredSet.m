% PREFERREDSET  Breaks ties among sure sets by the preference of the user.
%
% CALL: P = preferredSet (SURROGATES, PROBLEM, P, POOL)
%
% P     1 x d  surest set
% POOL  k x d  other sets that were found
%
% Looks, around p and the pool, for the least preference value among sets whose
% probability of meeting all targets is at most 0.02 below that of p and at
% least one half. A set that does not meet the targets is never preferred.
%
% See also: calibrateOnKriging, preferenceOf

function p = preferredSet (surrogates, problem, p, pool)
  best = meetProbability (surrogates, problem, p);
  if best < 0.5
    return
  end
  loss = @(P) preferenceIfSure (P, surrogates, problem, best);
  p = shrinkingSearch (loss, p, [0.2, 0.1, 0.05, 0.05, 0.02, 0.02], 200, ...
                       problem.limits, pool);
end

% Inf for a set that is less sure than the best one.
function value = preferenceIfSure (P, surrogates, problem, best)
  value = Inf (rows (P), 1);
  sure = meetProbability (surrogates, problem, P) >= max (0.5, best - 0.02);
  if any (sure)
    value(sure) = preferenceOf (problem, P(sure, :));
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
