% SAYUNITS  Warns where measured and simulated differ as two units do.
%
% CALL: sayUnits (TARGETS, SIMULATED, ORIGIN)
%
%   TARGETS    1 x T struct array with name and value (NaN: not measured)
%   SIMULATED  n x T, in the unit of the target; NaN where no run tells; the middle
%              of the runs counts
%   ORIGIN     of which runs that is, 'in this run' (text)
%
% See also: unitRatio

function sayUnits (targets, simulated, origin)
  for k = 1:numel (targets)
    known = simulated(isfinite (simulated(:, k)), k);
    middle = median ([known; NaN(1, isempty (known))]);
    ratio = unitRatio (middle, targets(k).value);
    if ~isempty (ratio)
      printf ('WARNING   %s: measured %.5g, %.5g %s: %s. Are both in one unit?\n', ...
              targets(k).name, targets(k).value, middle, origin, ratio);
    end
  end
end

%!test
%! T = struct ('name', {'height', 'slope', 'mass'}, 'value', {21, 30, NaN});
%! text = evalc ('sayUnits (T, [NA, 33, NaN; 0.02, 33, 1], ''in these runs'')');
%! assert (strncmp (text, 'WARNING   height: measured 21, 0.02 in these runs: a fac', 56));
%! assert (numel (strfind (text, 'WARNING')), 1);

% SPDX-License-Identifier: GPL-3.0-only
