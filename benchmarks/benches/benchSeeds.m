% BENCHSEEDS  Seeds of the packings that the bench programs use.
%
% CALL: SEEDS = benchSeeds (WHICH)
%
% WHICH  1 x n, integers from 1 to 8
% SEEDS  1 x n, primes above 10,000 as LIGGGHTS asks for
%
% See also: benchRuns

function seeds = benchSeeds (which)
  seeds = [10007, 10009, 10037, 10039, 10061, 10067, 10069, 10079];
  seeds = seeds(which);
end

%!assert (all (isprime (benchSeeds (1:8))))

% SPDX-License-Identifier: GPL-3.0-only
