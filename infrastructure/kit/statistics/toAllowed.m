% TOALLOWED  Allowed parameter sets, near the given ones.
%
% CALL: P = toAllowed (P, BOX)
%
% P    n x d, sets; one that is allowed stays, another moves towards the
%      nearest of the allowed sample as far as it has to
% BOX  see isAllowed; allowed also has sample (m x d, allowed sets)

function P = toAllowed (P, box)
  [yes, P] = isAllowed (P, box);
  if all (yes)
    return
  end
  U = toUnit (P(~yes, :), box.limits);
  V = toUnit (box.allowed.sample, box.limits);
  far = V;
  for i = 1:rows (U)
    [~, k] = min (sumsq (V - U(i, :), 2));
    far(i, :) = V(k, :);
  end
  P(~yes, :) = firstAllowed (U, far(1:rows (U), :), box);
end

% Where the way from U to V becomes allowed: V is.
function P = firstAllowed (U, V, box)
  at = @(share) isAllowed (fromUnit (U + share .* (V - U), box.limits), box);
  [low, high] = deal (zeros (rows (U), 1), ones (rows (U), 1));
  for k = 1:20
    middle = (low + high) / 2;
    yes = at (middle);
    high(yes) = middle(yes);
    low(~yes) = middle(~yes);
  end
  [~, P] = at (high);
end

%!test
%! box.limits = [0, 0; 1, 1];
%! box.allowed.values = {[], []};
%! box.allowed.rules = {@(P) P(:, 1) < P(:, 2)};
%! box.allowed.sample = [0.1, 0.2; 0.5, 0.6; 0.8, 0.95];
%! P = [0.2, 0.9; 0.9, 0.8; 0.5, 0.5; 0.6, 0.4];
%! Q = toAllowed (P, box);
%! assert (Q(1, :), P(1, :));
%! assert (Q(:, 1) < Q(:, 2));
%! assert (abs (Q - P)(2:4, :) < 0.14);
%! assert (toAllowed (Q, box), Q);
%!test <*47>
%! box.limits = [0.001, 1; 0.02, 4];
%! box.allowed.values = {[0.001, 0.002, 0.005, 0.02], 1:4};
%! box.allowed.rules = {@(P) P(:, 1) .* P(:, 2) <= 0.02};
%! box.allowed.sample = [0.001, 1; 0.005, 2; 0.002, 4];
%! restore = seedRandom (1);
%! Q = toAllowed (fromUnit (rand (50, 2), box.limits), box);
%! assert (all (ismember (Q(:, 1), box.allowed.values{1})));
%! assert (all (Q(:, 1) .* Q(:, 2) <= 0.02));
%! assert (rows (unique (Q, 'rows')) > 6);

% SPDX-License-Identifier: GPL-3.0-only
