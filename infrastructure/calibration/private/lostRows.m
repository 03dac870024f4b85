% LOSTROWS  Rows in which a model has no result at all.
%
% CALL: YES = lostRows (Z, BENCH)
%
%   Z      n x T, NaN: no result, NA: not run;  BENCH  1 x T, whose result each is
%   YES    n x 1 logical: the run failed. A run that lacks one result of several did not

function yes = lostRows (Z, bench)
  yes = false (rows (Z), 1);
  for k = unique (bench)
    own = Z(:, bench == k);
    yes = yes | (all (isnan (own), 2) & ~all (isna (own), 2));
  end
end

%!assert (lostRows ([1, NaN, 3; NaN, NaN, 3; 1, 2, NaN; NA, NA, 3], [1, 1, 2])', ...
%!        logical ([0, 1, 1, 0]));

% SPDX-License-Identifier: GPL-3.0-only
