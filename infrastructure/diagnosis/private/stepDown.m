% STEPDOWN  Tests several hypotheses with one chance of a false alarm (Holm 1979).
%
% CALL: [LEVEL, ISREJECTED] = stepDown (P, ALPHA [, REJECTS])
%
%   P        1 x m, chances of what was seen without a change
%   ALPHA    scalar, chance that any of them is rejected wrongly
%   REJECTS  handle, called in the order of P: IS = REJECTS (K, LEVEL) says whether
%            hypothesis K is rejected at LEVEL (default: whether P(K) < LEVEL)
%   LEVEL    1 x m, at which each was tested;  ISREJECTED  1 x m logical
%
% Each rejected one passes its alpha on to those with a larger p.

function [level, isRejected] = stepDown (p, alpha, rejects)
  if nargin < 3
    rejects = @(k, level) p(k) < level;
  end
  level = zeros (size (p));
  isRejected = false (size (p));
  [~, order] = sort (p);
  for k = order
    level(k) = alpha / (numel (p) - sum (isRejected));
    isRejected(k) = rejects (k, level(k));
  end
end

%!test
%! % the same in any order of the table: the second and third by what the first
%! % passes on
%! for order = perms (1:3)'
%!   p = [0.001, 0.02, 0.03](order');
%!   [level, isRejected] = stepDown (p, 0.05);
%!   assert (isRejected, true (1, 3));
%!   assert (level(order' == 1), 0.05 / 3, 1e-12);
%!   assert (level(order' == 3), 0.05, 1e-12);
%! end
%! % the first that is not rejected ends it
%! [level, isRejected] = stepDown ([0.04, 0.01, 0.03], 0.05);
%! assert (isRejected, [false, true, false]);
%! assert (level, [0.025, 0.05 / 3, 0.025], 1e-12);
%!test
%! % one that is small for another reason passes nothing on
%! [level, isRejected] = stepDown ([0.001, 0.02], 0.05, @(k, level) k == 2);
%! assert (level, [0.025, 0.025]);
%! assert (isRejected, [false, true]);
%!assert (stepDown (0.3, 0.05), 0.05)

% SPDX-License-Identifier: GPL-3.0-only
