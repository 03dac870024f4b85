% NOISYCOVARIANCE  A covariance of stk, and the noise of the runs along an input.
%
% CALL: K = noisyCovariance (KERNEL, PARAM, X, Y [, DIFF [, PAIRWISE]])
%
%   KERNEL  handle or name of an anisotropic covariance of stk
%   PARAM   its parameters, and after them the logarithm of the variance of a
%           run where the last input is 0, and its slope along it
%   others  as stk calls a covariance; the noise is there where Y is X
%
% stk fits it as any covariance, but within no bounds, as it knows none: beyond
% 20, where nothing but the prior of a logarithm changes, it stays as it is. stk
% predicts by the kernel alone, with the noise that came out, a number for each run.

function K = noisyCovariance (kernel, param, x, y, diff, pairwise)
  if nargin < 5
    diff = -1;
  end
  if nargin < 6
    pairwise = false;
  end
  param = max (min (param, 20), -20);
  count = numel (param) - 2;
  if diff <= count
    K = feval (kernel, param(1:count), x, y, diff, pairwise);
  else
    n = rows (x);
    K = zeros (n, rows (y));
    if pairwise
      K = zeros (n, 1);
    end
  end
  if isequal (x, y) && (diff == -1 || diff > count)
    noise = exp (param(end - 1) + param(end) * x(:, end));
    if diff == count + 2
      noise = noise .* x(:, end);
    end
    if ~pairwise
      noise = diag (noise);
    end
    K = K + noise;
  end
end

%!test
%! % value at the runs and away from them; slopes against differences
%! pkg load stk
%! kernel = @stk_materncov52_aniso;
%! param = [0.1; 0.2; -0.3; -2; 0.7];
%! X = [0.1, 0; 0.5, 1; 0.9, 0.5];
%! K = noisyCovariance (kernel, param, X, X);
%! k = feval (kernel, param(1:3), X, X);
%! assert (K - k, diag (exp ([-2, -1.3, -1.65])), 1e-12);
%! assert (noisyCovariance (kernel, param, X, X, -1, true), diag (K), 1e-12);
%! assert (noisyCovariance (kernel, param, X, X(1, :)), k(:, 1), 1e-12);
%! for j = 1:5
%!   h = 1e-5 * ((1:5)' == j);
%!   up = noisyCovariance (kernel, param + h, X, X);
%!   down = noisyCovariance (kernel, param - h, X, X);
%!   assert (noisyCovariance (kernel, param, X, X, j), (up - down) / 2e-5, 1e-8);
%! end

% SPDX-License-Identifier: GPL-3.0-only
