% PLAINEVALUATE  Makes of a function that gives results one that addRuns calls.
%
% CALL: EVALUATE = plainEvaluate (F)
%
%   F         handle Z = F (P, E, REPLICATE), or with a fourth argument, STAGE
%   EVALUATE  see addRuns

function evaluate = plainEvaluate (f)
  if nargin (f) >= 0 && nargin (f) <= 3
    f = @(P, E, replicate, stage) f (P, E, replicate);
  end
  evaluate = @(P, E, replicate, stage, budget) ...
    counted (f (P, E, replicate, stage), budget);
end

function [Z, budget] = counted (Z, budget)
  isTried = ~any (isna (Z), 2);
  n = sum (isTried) * budget.perSet;
  budget.new = budget.new + n;
  budget.left = budget.left - n;
  budget.failed = budget.failed + sum (any (isnan (Z(isTried, :)), 2));
  budget.isUsedUp = budget.isUsedUp || ~all (isTried);
end

%!test
%! f = plainEvaluate (@(P, E, r, stage) [P + E, merge(r > 1, NaN, r)]);
%! [Z, budget] = f ([1; 2], [3; 4], [1; 2], 'plan', newBudget ());
%! assert (Z, [4, 1; 6, NaN]);
%! assert ([budget.new, budget.failed, budget.isUsedUp], [2, 1, 0]);
