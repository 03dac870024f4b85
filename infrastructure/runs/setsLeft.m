% SETSLEFT  Parameter sets that may still be run in this start.
%
% CALL: N = setsLeft (BUDGET)
%
%   BUDGET  see newBudget
%   N       scalar; runs in the store cost nothing, so where no run is left it
%           is Inf until a set was wanted that is not in the store
%
% See also: newBudget, budgetLeft

function n = setsLeft (budget)
  n = floor (budget.left / budget.perSet);
  if n < 1
    n = merge (budget.isUsedUp, 0, Inf);
  end
end

%!test
%! budget = setfield (newBudget (), 'perSet', 2);
%! budget.left = 7;
%! assert (setsLeft (budget), 3);
%! budget.left = 1;
%! assert (setsLeft (budget), Inf);
%! budget.isUsedUp = true;
%! assert (setsLeft (budget), 0);
