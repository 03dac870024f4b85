% TAPPEDSHARE  Compaction by taps: slow, with the logarithm of their number.
%
% CALL: S = tappedShare (TAPS, TIME, STEP)
%
%   TAPS  1 x m, number of taps from 0
%   TIME  n x 1, taps after which it sets in
%   STEP  n x 1, how much a factor e of taps brings
%   S     n x m, share of the gap to the densest packing that is closed, [0, 1)
%
% S = 1 - 1 / (1 + B log (1 + t / tau)), Knight et al. 1995.
%
% See also: foreignLab

function S = tappedShare (taps, time, step)
  S = 1 - 1 ./ (1 + step .* log1p (taps ./ time));
end

%!test
%! S = tappedShare ([0, 10, 100, 1e4], 10, 0.3);
%! assert (S(1), 0);
%! assert (S(2), 1 - 1 / (1 + 0.3 * log (2)), 1e-12);
%! assert (all (diff (S) > 0) && S(4) < 1);
