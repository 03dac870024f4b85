% PREFERREDSET  Breaks ties among sure sets by the preference of the user.
%
% CALL: p = preferredSet (surrogates, problem, p, pool)
%
% p     1 x d  surest set
% pool  k x d  other sets that were found
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
  lo = problem.limits(1, :);
  width = problem.limits(2, :) - lo;
  d = numel (lo);
  unit = double (stk_sampling_halton_rr2 (200, d, [-ones(1, d); ones(1, d)]));
  value = preferenceOf (problem, p);
  for radius = [0.2, 0.1, 0.05, 0.05, 0.02, 0.02]
    P = p + radius * unit .* width;
    P = [min(max (P, lo), problem.limits(2, :)); pool];
    sure = meetProbability (surrogates, problem, P) >= ...
           max (0.5, best - 0.02);
    P = P(sure, :);
    values = preferenceOf (problem, P);
    [least, i] = min (values);
    if ~isempty (P) && least < value
      value = least;
      p = P(i, :);
    end
  end
end
