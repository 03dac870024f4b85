% TARGETRESIDUAL  Residuals of the targets, and how they follow the results.
%
% CALL: [R, SLOPE] = targetResidual (PROBLEM, P, Z)
%
% P        n x d  parameter sets
% Z        n x T  results
% R        n x T  residual rows of the cost function (NaN where Z is NaN, or
%                 the target is not measured yet)
% SLOPE    n x T  derivative of each residual by its own result
%
% The published residual is computed for all rows at once; any other cost
% function is called row by row, differentiated by 1 % of the tolerance.

function [r, slope] = targetResidual (problem, P, Z)
  n = size (Z, 1);
  if problem.standard
    r = (Z - problem.value) ./ problem.scale;
    slope = repmat (1 ./ problem.scale, n, 1);
    return
  end
  [r, slope] = deal (zeros (n, columns (Z)));
  step = max (0.01 * problem.tol .* abs (problem.scale), realmin);
  for i = 1:n
    r(i, :) = costRows (problem, P(i, :), Z(i, :));
    if nargout > 1
      ahead = costRows (problem, P(i, :), Z(i, :) + step);
      slope(i, :) = (ahead - r(i, :)) ./ step;
    end
  end
  r(isnan (Z)) = NaN;
end

function r = costRows (problem, p, z)
  r = problem.cost (p(:), @(varargin) z(:));
  r = r(1:numel (z))(:)';
end

%!test
%! C = struct ('names', {{'a'}}, 'limits', [0; 1], ...
%!             'targets', struct ('value', {4, 2}, 'tol', 0.01));
%! P = [0.1; 0.2];
%! Z = [4.4, 1; 2, NaN];
%! [r, s] = targetResidual (newProblem (C, []), P, Z);
%! assert (r, [0.1, -0.5; -0.5, NaN], 1e-12);
%! [q, t] = targetResidual (newProblem (C, @(p, f) f (p) - [4; 2]), P, Z);
%! assert (q, [0.4, -1; -2, NaN], 1e-12);
%! assert (t(1, :), [1, 1], 1e-6);

% SPDX-License-Identifier: GPL-3.0-only
