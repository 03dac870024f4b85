% LEVELSHARE  How much of what effects do changes from coarse to fine runs.
%
% CALL: SHARE = levelShare (EMULATOR, COARSE, RUNS)
%
%   EMULATOR  struct of fitEmulator: noiseVar and range
%   COARSE  1 x K struct of learnEffect, from coarse runs alone
%   RUNS    those of the last level, see learnEffect, with phi n x K
%   SHARE   standard deviation of the change, as a share of the effect
%
% What runs of one effect at the last level give beyond what coarse ones
% foretell and noise explains, over what the effect does; all effects together,
% in units of what the parameters move. Nobody knows before the first such run:
% 0.3, which counts as much as two effects.

function share = levelShare (emulator, coarse, runs)
  isOn = abs (runs.phi) >= 1e-9;
  [excess, size2, seen] = deal (0);
  for k = find (~[coarse.laboratory] & [coarse.runs] > 0)
    isAlone = isOn(:, k) & sum (isOn, 2) == 1;
    if ~any (isAlone)
      continue
    end
    e = coarse(k);
    phi = runs.phi(isAlone, k);
    psi = bentStrength (phi, e.bend);
    B = polyRows (e.powers, [runs.theta(isAlone, :), psi]);
    miss = runs.Z(isAlone, :) - runs.mean(isAlone, :) - B * e.coef;
    % noise and surrogates make differences, too: their square is expected
    known = emulator.noiseVar + runs.variance(isAlone, :) + ...
            effectVariance (e, B, psi);
    ok = isfinite (miss);
    miss(~ok) = 0;
    weight = ok ./ emulator.range.^2;
    excess = excess + sum (sum ((miss.^2 - known) .* weight));
    size2 = size2 + sum (sum (phi.^2 .* e.size2 .* weight));
    seen = seen + 1;
  end
  found = 0;
  if size2 > 0
    % an estimate of a variance may come out negative, or above the effect itself
    found = min (max (excess / size2, 0), 1);
  end
  % 0.3 beforehand, with the weight of two effects; each that was seen counts once
  share = sqrt ((2 * 0.3^2 + seen * found) / (2 + seen));
end

%!test
%! % effects half as large at the last level, or the same (no noise)
%! emulator = struct ('noiseVar', 1e-6, 'range', 1);
%! e = struct ('laboratory', false, 'runs', 4, 'bend', 1, 'powers', [0, 1], ...
%!             'coef', 2, 'misfit', 1e-6, 'root', zeros (1, 0), ...
%!             'ofTarget', zeros (0, 1), 'size2', 4);
%! runs = struct ('theta', [0; 0.5], 'phi', [1; 0.5], 'Z', [1; 0.5], ...
%!                'mean', [0; 0], 'variance', [0; 0]);
%! assert (levelShare (emulator, e, runs), sqrt ((2 * 0.09 + 0.25) / 3), 1e-3);
%! runs.Z = [2; 1];
%! assert (levelShare (emulator, e, runs), sqrt (2 * 0.09 / 3), 1e-3);
%! runs.phi = [0; 0];
%! assert (levelShare (emulator, e, runs), 0.3);

% SPDX-License-Identifier: GPL-3.0-only
