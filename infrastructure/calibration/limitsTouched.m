% LIMITSTOUCHED  Names of the parameters that stand at a limit.
%
% CALL: NAMES = limitsTouched (PARAMS, PROBLEM)
%
% PARAMS  1 x d; PROBLEM  struct of newProblem; NAMES  cellstr
%
% Touched: within 0.5 % of the width of the box.
%
% See also: checkSurrogates

function names = limitsTouched (params, problem)
  u = (params(:)' - problem.limits(1, :)) ./ diff (problem.limits);
  names = problem.names(u < 0.005 | u > 0.995);
end

%!test
%! problem = struct ('limits', [0, 0; 2, 10], 'names', {{'a', 'b'}});
%! assert (limitsTouched ([2; 5], problem), {'a'});
%! assert (isempty (limitsTouched ([1, 1], problem)));
