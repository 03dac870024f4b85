% BINOMIALINTERVAL  Gives the exact interval of a share (Clopper-Pearson).
%
% CALL: [LO, HI] = binomialInterval (K, N, LEVEL)
%
%   K, N    scalars, K hits of N (K = 0 ... N)
%   LEVEL   scalar, confidence (0.95)
%   LO, HI  scalars; 0 and 1 where N is 0
%
% Solved by bisection of the regularised incomplete beta function.
%
% See also: scoreDiagnoses

function [lo, hi] = binomialInterval (k, n, level)
  if nargin < 3
    level = 0.95;
  end
  tail = (1 - level) / 2;
  lo = 0;
  hi = 1;
  if n > 0 && k > 0
    lo = bisect (@(p) betainc (p, k, n - k + 1) - tail);
  end
  if n > 0 && k < n
    hi = bisect (@(p) betainc (p, k + 1, n - k) - (1 - tail));
  end
end

function p = bisect (f)
  a = 0;
  b = 1;
  for i = 1:60
    p = (a + b) / 2;
    if f (p) < 0
      a = p;
    else
      b = p;
    end
  end
end

%!test
%! [lo, hi] = binomialInterval (0, 60);
%! assert (lo, 0);
%! assert (hi, 1 - 0.025^(1 / 60), 1e-9);
%! [lo, hi] = binomialInterval (54, 60);
%! assert ([lo, hi], [0.795, 0.962], 2e-3);

% SPDX-License-Identifier: GPL-3.0-only
