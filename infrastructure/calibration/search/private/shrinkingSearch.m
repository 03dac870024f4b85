% SHRINKINGSEARCH  Looks for a better set around a set, ever nearer.
%
% CALL: P = shrinkingSearch (LOSS, P, RADII, N, BOX [, BESIDE])
%
% LOSS    handle: P m x d -> m x 1, Inf where a set is out of the question
% P       1 x d, the start; comes back as the best set that was seen
% RADII   1 x k, half widths of the neighbourhoods, as parts of the box
% N       sets per neighbourhood (a low-discrepancy sequence)
% BOX     struct of newProblem, or its limits, see setsAround
% BESIDE  m x d, sets that are looked at beside each neighbourhood (none)

function p = shrinkingSearch (loss, p, radii, n, box, beside)
  if nargin < 6
    beside = zeros (0, columns (p));
  end
  d = columns (p);
  unit = double (stk_sampling_halton_rr2 (n, d, [-ones(1, d); ones(1, d)]));
  value = loss (p);
  for radius = radii
    P = [setsAround(p, radius * unit, box); beside];
    [least, i] = min (loss (P));
    if least < value
      value = least;
      p = P(i, :);
    end
  end
end

%!shared loss, limits
%! loss = @(P) sumsq (P - [3, 9], 2);
%! limits = [0, 0; 10, 10];
%!test
%! p = shrinkingSearch (loss, [5, 5], [0.3, 0.2, 0.1, 0.05], 100, limits);
%! assert (p, [3, 9], 0.3);
%!assert (shrinkingSearch (loss, [5, 5], 0.01, 9, limits, [3, 9]), [3, 9])
%!test
%! never = @(P) Inf (rows (P), 1);
%! assert (shrinkingSearch (never, [5, 5], 0.1, 9, limits), [5, 5]);

% SPDX-License-Identifier: GPL-3.0-only
