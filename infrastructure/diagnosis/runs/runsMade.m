% RUNSMADE  How many sets a diagnosis has run, and how many of them failed.
%
% CALL: MADE = runsMade (STATE, KNOWN)
%
%   STATE  of newGapState;  KNOWN  the data that it began with
%   MADE   struct spent, failed (of these)

function made = runsMade (state, known)
  Z = state.data.Z(rows (known.Z) + 1:end, :);
  made = struct ('spent', rows (Z), 'failed', sum (any (isnan (Z) & ~isna (Z), 2)));
end

%!assert (runsMade (struct ('data', struct ('Z', [1, NA; NaN, NA; 3, NA; NaN, NA])), ...
%!                  struct ('Z', [1, NA; NaN, NA])), struct ('spent', 2, 'failed', 1))

% SPDX-License-Identifier: GPL-3.0-only
