% VALUESOFSTRENGTH  Turns strengths phi into values of the effect variables.
%
% CALL: E = valuesOfStrength (EFFECTS, PHI)
%
%   EFFECTS  1 x K struct of newEffect
%   PHI      n x K, strengths (0 = neutral)
%   E        n x v, values of the variables of all effects that DEM runs

function E = valuesOfStrength (effects, phi)
  E = zeros (rows (phi), 0);
  for k = 1:numel (effects)
    e = effects(k);
    if ~isempty (e.variables)
      E = [E, valuesOf(e, phi(:, k))];
    end
  end
end

function values = valuesOf (effect, phi)
  lo = effect.limits(1, :) - effect.neutral;
  up = effect.limits(2, :) - effect.neutral;
  if effect.range(1) >= 0
    far = abs (lo) > abs (up);
    up(far) = lo(far);
  end
  values = effect.neutral + max (phi, 0) .* up + max (-phi, 0) .* lo;
end

%!test
%! % there and back
%! a = struct ('name', 'a', 'variables', {{'x'}}, 'neutral', 0, ...
%!             'limits', [1; 4]);
%! b = struct ('name', 'b', 'variables', {{'u', 'w'}}, 'neutral', [1, 0], ...
%!             'limits', [0.5, -1; 2, 1]);
%! effects = [newEffect(a, 1), newEffect(b, 1)];
%! phi = [0, 0; 0.3, 0; 0, 0.7; 0, -0.2];
%! again = strengthOfValues (effects, valuesOfStrength (effects, phi));
%! assert (again, phi, 1e-14);
%!assert (size (valuesOfStrength ([], zeros (3, 0))), [3, 0])

% SPDX-License-Identifier: GPL-3.0-only
