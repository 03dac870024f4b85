% ERRORVARIANCE  Variance of a measured value about the mean response.
%
% CALL: [V, ISUNSEEN] = errorVariance (NOISEVAR, PROBLEM, T)
%
%   NOISEVAR  scalar, variance of a run
%   T         number of the target
%   V         the packing of the trials that were averaged, and the uncertainty
%             of the measurement; where that comes from the scatter of the
%             trials it holds their packings already, and the larger counts
%   ISUNSEEN  logical: nobody has given an uncertainty, and the runs show less
%             than a tenth of the tolerance. That counts then: a scatter that
%             was not seen is not zero

function [v, isUnseen] = errorVariance (noiseVar, problem, t)
  parts = [noiseVar / problem.trials(t), problem.statedSd(t)^2];
  v = merge (problem.scatter(t), max (parts), sum (parts));
  least = (problem.tol(t) * problem.scale(t) / 10)^2;
  isUnseen = problem.statedSd(t) == 0 && v < least;
  if isUnseen
    v = least;
  end
end

%!test
%! problem = struct ('trials', [1, 4], 'statedSd', [0.3, 0], 'tol', [0.1, 0.1], ...
%!                   'scatter', [true, false], 'scale', [100, 4]);
%! assert (errorVariance (0.04, problem, 1), 0.09, 1e-12);
%! problem.scatter(1) = false;
%! [v, isUnseen] = errorVariance (0.04, problem, 1);
%! assert ({v, isUnseen}, {0.13, false}, 1e-12);
%! [v, isUnseen] = errorVariance (0.001, problem, 2);
%! assert ({v, isUnseen}, {0.0016, true}, 1e-12);

% SPDX-License-Identifier: GPL-3.0-only
