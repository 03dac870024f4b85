% SETSAROUND  Sets around a set, within the box.
%
% CALL: P = setsAround (P, STEP, BOX)
%
% P       1 x d or n x d
% STEP    n x d, as parts of the box
% BOX     struct: limits (2 x d, see toUnit), allowed (see isAllowed); or
%         limits alone
% P       n x d, allowed sets; what would lie outside lies on the limit

function P = setsAround (p, step, box)
  if ~isstruct (box)
    box = struct ('limits', box);
  end
  limits = box.limits;
  P = p + step .* (limits(2, :) - limits(1, :));
  isLog = any (limits(3:end, :), 1);
  if any (isLog)
    moved = fromUnit (toUnit (p, limits) + step, limits);
    P(:, isLog) = moved(:, isLog);
  end
  P = toAllowed (min (max (P, limits(1, :)), limits(2, :)), box);
end

%!assert (setsAround ([1, 5], [0.1, 0.5; -0.2, 0.1], [0, 0; 10, 10]), ...
%!        [2, 10; 0, 6])

% SPDX-License-Identifier: GPL-3.0-only
