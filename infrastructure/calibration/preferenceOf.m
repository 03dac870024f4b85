% PREFERENCEOF  What speaks against a set beside its targets, as one number.
%
% CALL: VALUE = preferenceOf (PROBLEM, P)
%
% PROBLEM  struct of newProblem
% P        n x d  parameter sets
% VALUE    n x 1  sum of squares of the rows below the targets (the Rayleigh
%                 term) and of the distances to parameters that were measured
%                 by themselves, in their standard deviations; 0 where there
%                 is neither
%
% See also: targetResidual, calibrateOnKriging

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

%!test
%! C = struct ('names', {{'a'}}, 'limits', [0; 1], ...
%!             'targets', struct ('value', 4, 'tol', 0.01));
%! problem = newProblem (C, @(p, f) [f(p) / 4 - 1; 2 * p]);
%! assert (preferenceOf (problem, [1; 3]), [4; 36]);
%! assert (preferenceOf (newProblem (C, []), [1; 3]), [0; 0]);
%! C.paramMean = 2;
%! C.paramSd = 0.5;
%! assert (preferenceOf (newProblem (C, []), [1; 3; 2]), [4; 4; 0]);
