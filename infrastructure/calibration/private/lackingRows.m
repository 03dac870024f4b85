% LACKINGROWS  Which runs lack a result, and have others of the same test.
%
% CALL: [LACKS, HASANY] = lackingRows (Z, BENCH)
%
%   Z      n x T, NaN: no result, NA: not run;  BENCH  1 x T, whose result each is
%   LACKS  n x T logical: the run has another result of that test, and not this one
%   HASANY n x T logical: the run has a result of that test

function [lacks, hasAny] = lackingRows (Z, bench)
  hasAny = false (size (Z));
  for k = unique (bench)
    own = bench == k;
    hasAny(:, own) = repmat (any (isfinite (Z(:, own)), 2), 1, sum (own));
  end
  lacks = hasAny & isnan (Z) & ~isna (Z);
end

%!test
%! [lacks, hasAny] = lackingRows ([1, NaN, 3; NaN, NaN, 3; 1, NA, NaN], [1, 1, 2]);
%! assert (lacks, logical ([0, 1, 0; 0, 0, 0; 0, 0, 0]));
%! assert (hasAny, logical ([1, 1, 1; 0, 0, 1; 1, 1, 0]));

% SPDX-License-Identifier: GPL-3.0-only
