% SAMPLEBOX  Sets that fill the box evenly, the same at every call.
%
% CALL: P = sampleBox (N, LIMITS)
%
% LIMITS  2 x d, or 3 x d, the box, see toUnit
% P       n x d, a low-discrepancy sequence (Halton, scrambled by RR2)

function P = sampleBox (n, limits)
  d = columns (limits);
  unit = double (stk_sampling_halton_rr2 (n, d, [zeros(1, d); ones(1, d)]));
  P = fromUnit (unit, limits);
end

%!test
%! limits = [0.3, -2, 1e5; 0.7, 5, 1e9];
%! assert (sampleBox (40, limits), ...
%!         double (stk_sampling_halton_rr2 (40, 3, limits)));
%! P = sampleBox (100, [limits; 0, 0, 1]);
%! assert (mean (P(:, 3) < 1e7), 0.5, 0.05);

% SPDX-License-Identifier: GPL-3.0-only
