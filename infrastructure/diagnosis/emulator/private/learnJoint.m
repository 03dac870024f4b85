% LEARNJOINT  Learns what two effects do together beyond what each does alone.
%
% CALL: JOINT = learnJoint (EMULATOR, RUNS)
%
%   EMULATOR  struct of fitEmulator with its effects
%   RUNS   all runs, see learnEffect; phi n x K
%   JOINT  1 x J struct, of each pair of effects that DEM runs: members, powers,
%          coef (q x T), bend, misfit (1 x T: variance over the product of the
%          bent strengths squared), root and ofTarget (empty, see learnEffect),
%          laboratory (false), runs
%
% Without a run the two add up, within 0.3 of the geometric mean of their sizes:
% nobody knows yet. Runs with both effects on (rows of a factorial plan) replace
% that guess by a product term that may change with the parameters.

function joint = learnJoint (emulator, runs)
  joint = [];
  simulated = find (~[emulator.effect.laboratory] & [emulator.effect.runs] > 0);
  if numel (simulated) < 2
    return
  end
  isOn = abs (runs.phi) >= 1e-9;
  for pair = nchoosek (simulated, 2)'
    at = all (isOn(:, pair), 2) & sum (isOn, 2) == 2;
    both = struct ('theta', runs.theta(at, :), 'phi', runs.phi(at, pair), ...
                   'Z', runs.Z(at, :), 'mean', runs.mean(at, :), ...
                   'variance', runs.variance(at, :));
    joint = [joint, ofPair(emulator, pair', both)];
  end
end

function joint = ofPair (emulator, pair, runs)
  p = emulator.p;
  T = columns (emulator.coef);
  one = emulator.effect(pair(1));
  two = emulator.effect(pair(2));
  alone = @(e) abs (polyRows (e.powers, [zeros(1, p), 1]) * e.coef);
  least = (1e-8 * emulator.range).^2;
  guess = 0.3^2 * alone (one) .* alone (two) + least;
  joint = struct ('members', pair, 'powers', zeros (0, p + 2), ...
                  'coef', zeros (0, T), 'bend', [1, 1], 'laboratory', false, ...
                  'runs', rows (runs.Z), 'misfit', guess, ...
                  'root', zeros (0, 0), 'ofTarget', zeros (0, T));
  if rows (runs.Z) == 0
    return
  end
  phi = runs.phi;
  psi = bentStrength (phi, [one.bend, two.bend]);
  % the product of both strengths, which may change along each parameter
  joint.powers = [[zeros(1, p); eye(p)], ones(p + 1, 2)];
  joint.coef = zeros (p + 1, T);
  joint.root = zeros (p + 1, 0);
  m = runs.mean;
  v = runs.variance;
  for i = 1:2
    e = emulator.effect(pair(i));
    B = polyRows (e.powers, [runs.theta, psi(:, i)]);
    % what each does alone is taken out, and what is not known of that is noise here
    m = m + B * e.coef;
    v = v + effectVariance (e, B, psi(:, i));
  end
  product = prod (psi, 2);
  for t = 1:T
    ok = isfinite (runs.Z(:, t));
    if any (ok)
      fit = fitEffect (joint.powers, [runs.theta(ok, :), psi(ok, :)], ...
                       [runs.Z(ok, t) - m(ok, t), product(ok)], ...
                       emulator.noiseVar(t) + v(ok, t));
      joint.coef(:, t) = fit.coef;
      % runs of both can only take from the doubt that there was without them
      left = fit.covariance(1) + fit.misfit + least(t);
      joint.misfit(t) = min (left, guess(t));
    end
  end
end

%!test
%! % two effects that double each other: seen from a few runs (seeded)
%! rand ('twister', 3); randn ('twister', 3);
%! emulator = struct ('p', 1, 'coef', zeros (1, 2), 'noiseVar', [0.01, 0.01], ...
%!              'range', [4, 1]);
%! emulator.effect = struct ('powers', [0, 1], 'coef', {[4, 0], [4, 1]}, ...
%!                     'bend', 1, 'misfit', 1e-4 * [1, 1], ...
%!                     'root', zeros (1, 0), 'ofTarget', zeros (0, 2), ...
%!                     'laboratory', false, 'runs', 8);
%! none = struct ('theta', 0, 'phi', [1, 0], 'Z', [1, 1], 'mean', [1, 1], ...
%!                'variance', [0, 0]);
%! none = learnJoint (emulator, none);
%! assert (none.misfit, [0.09 * 16, 0], 1e-9);
%! Q = [2 * rand(8, 1) - 1, 0.3 + 0.7 * rand(8, 2)];
%! Z = [4 * Q(:, 2) + 4 * Q(:, 3) + 4 * Q(:, 2) .* Q(:, 3), Q(:, 3)] + ...
%!     0.1 * randn (8, 2);
%! runs = struct ('theta', Q(:, 1), 'phi', Q(:, 2:3), 'Z', Z, ...
%!                'mean', 0 * Z, 'variance', 0 * Z);
%! joint = learnJoint (emulator, runs);
%! assert (joint.coef(1, 1), 4, 0.6);
%! assert (joint.misfit(1) < none.misfit(1));

% SPDX-License-Identifier: GPL-3.0-only
