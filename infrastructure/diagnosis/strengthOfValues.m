% STRENGTHOFVALUES  Turns effect variables of runs into strengths phi.
%
% CALL: PHI = strengthOfValues (EFFECTS, E)
%
%   EFFECTS  1 x K struct of newEffect
%   E        n x v, values of the variables of all effects that DEM runs, in
%            the order of EFFECTS
%   PHI      n x K, 0 = neutral, 1 = full strength; 0 for the laboratory
%
% Of an effect with several variables the one that moved most counts.
%
% Errors: DEcalioc:strengthOfValues:badShape

function phi = strengthOfValues (effects, E)
  counts = arrayfun (@(e) numel (e.variables), effects);
  if columns (E) ~= sum (counts)
    error ('DEcalioc:strengthOfValues:badShape', ...
           'strengthOfValues: E must have %d columns, got %d.', ...
           sum (counts), columns (E));
  end
  phi = zeros (rows (E), numel (effects));
  first = cumsum ([0, counts]);
  for k = find (counts > 0)
    phi(:, k) = strengthOf (effects(k), E(:, first(k) + 1:first(k + 1)));
  end
end

function phi = strengthOf (effect, values)
  move = values - effect.neutral;
  down = effect.limits(1, :) - effect.neutral;
  up = effect.limits(2, :) - effect.neutral;
  if effect.range(1) >= 0
    far = abs (down) > abs (up);
    up(far) = down(far);
  end
  share = move ./ up;
  if effect.range(1) < 0
    back = move .* up < 0;
    other = -move ./ down;
    share(back) = other(back);
  end
  share(~isfinite (share)) = 0;
  [~, most] = max (abs (share), [], 2);
  phi = share(sub2ind (size (share), (1:rows (share))', most));
end

%!shared effects
%! a = struct ('name', 'a', 'variables', {{'x'}}, 'neutral', 0, ...
%!             'limits', [1; 4]);
%! b = struct ('name', 'b', 'variables', {{'u', 'w'}}, 'neutral', [1, 0], ...
%!             'limits', [0.5, -1; 2, 1]);
%! effects = [newEffect(a, 1), newEffect(b, 1)];
%!assert (strengthOfValues (effects, [2, 1, 0]), [0.5, 0])
%!assert (strengthOfValues (effects, [0, 2, 1]), [0, 1])
%!assert (strengthOfValues (effects, [0, 0.75, -0.5]), [0, -0.5])
%!error id=DEcalioc:strengthOfValues:badShape strengthOfValues (effects, 1)

% SPDX-License-Identifier: GPL-3.0-only
