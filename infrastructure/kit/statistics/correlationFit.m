% CORRELATIONFIT  How well a correlation explains errors of unknown size.
%
% CALL: FIT = correlationFit (E, R)
%
%   E    n x m, n independent rows of m errors; their variance is not known
%   R    m x m, correlation of the m
%   FIT  scalar, log likelihood with the variance at its maximum, up to a
%        constant; -Inf where R is no correlation
%
% See also: correlateSeries, jointErrors

function fit = correlationFit (E, R)
  [n, m] = size (E);
  % two places that are the same would make it singular
  R(1:m + 1:end) = 1 + 1e-6;
  [root, flaw] = chol (R, 'lower');
  fit = -Inf;
  if ~flaw
    fit = -n * m / 2 * log (sum (sumsq (root \ E')) / (n * m)) - ...
          n * sum (log (diag (root)));
  end
end

%!test
%! % the length of errors that were drawn with it
%! randn ('twister', 3);
%! D = abs ((1:40)' - (1:40));
%! E = 7 * randn (30, 40) * chol (exp (-D / 5));
%! fits = arrayfun (@(len) correlationFit (E, exp (-D / len)), [1, 5, 25]);
%! assert (fits(2) > max (fits([1, 3])));
%! assert (correlationFit (E, 2 - D), -Inf);

% SPDX-License-Identifier: GPL-3.0-only
