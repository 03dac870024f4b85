% SETSLEFT  How many sets may still be run of all models of a set.
%
% CALL: N = setsLeft (BUDGET)
%
%   BUDGET  see newEvaluate;  N  scalar, Inf without a limit

function n = setsLeft (budget)
  n = floor (budget.left / sum (budget.models));
end

%!assert (setsLeft (struct ('left', 7, 'models', [true, false, true])), 3)
%!assert (setsLeft (struct ('left', Inf, 'models', true)), Inf)
