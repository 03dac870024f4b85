% RUNCOVARIANCE  Covariance of runs around the baseline surrogate.
%
% CALL: C = runCovariance (THETA, V, NOISEVAR)
%
%   THETA     n x p, parameters of the runs in [-1, 1]
%   V         n x 1, variance of the baseline surrogate there
%   NOISEVAR  scalar, variance of one run
%   C         n x n: noise of the runs, and the error of the baseline: a plane
%             through the box carries seven tenths of its variance, the rest is
%             independent
%
% See also: learnEffect, pooledNoise

function C = runCovariance (theta, v, noiseVar)
  [n, p] = size (theta);
  root = sqrt (v);
  plane = [ones(n, 1), theta];
  shared = (plane .* [0.4, 0.9 / p * ones(1, p)]) * plane';
  C = (root * root') .* shared + diag (noiseVar + 0.3 * v);
end

%!test
%! C = runCovariance ([0; 0; 0.577], 4 * ones (3, 1), 6);
%! assert (C(1, 1), 6 + 4 * 0.4 + 4 * 0.3, 1e-9);
%! assert (C(1, 2), 4 * 0.4, 1e-9);
%! assert (C(3, 3), 6 + 4 * (0.4 + 0.3) + 4 * 0.3, 0.01);
