% PREFERENCEOF  The preference rows of the cost function, as one number a set.
%
% CALL: value = preferenceOf (problem, P)
%
% problem  struct of newProblem
% P        n x d  parameter sets
% value    n x 1  sum of squares of the rows below the targets (the Rayleigh
%                 term); 0 where the cost function has none
%
% See also: targetResidual, calibrateOnKriging

function value = preferenceOf (problem, P)
  value = zeros (size (P, 1), 1);
  if problem.nExtra == 0
    return
  end
  T = numel (problem.value);
  for i = 1:size (P, 1)
    r = problem.cost (P(i, :)', @(varargin) problem.value(:));
    value(i) = sum (r(T + 1:end).^2);
  end
end

%!test
%! C = struct ('names', {{'a'}}, 'limits', [0; 1], ...
%!             'targets', struct ('value', 4, 'tol', 0.01));
%! problem = newProblem (C, @(p, f) [f(p) / 4 - 1; 2 * p]);
%! assert (preferenceOf (problem, [1; 3]), [4; 36]);
%! assert (preferenceOf (newProblem (C, []), [1; 3]), [0; 0]);
