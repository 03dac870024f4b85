% STANDINGAP  A laboratory of formulas: benches, effects and truth known.
%
% CALL: LAB = standInGap (CURVATURE, SEED)
%
%   CURVATURE  scalar, 0 = all responses linear, 0.3 = mildly nonlinear (0.3)
%   SEED       scalar, number of the laboratory: each has laws of its own (11)
%   LAB        struct
%     problem     as newProblem wants it, value still NaN; 24 targets on 4
%              benches, 4 parameters, 8 effects that DEM would run, 2 of the
%              laboratory
%     means    handle, Z = means (THETA, PHI): n x 24 results without noise;
%              THETA n x 4 in [0, 1], PHI n x 10 strengths
%     noiseSd  1 x 24, noise of one run
%     plan     handle, data = plan (N0, NK): runs with N0 neutral rows and NK
%              rows for each of the 8 effects, from the current random state
%
% Stands in for DEM where a test needs a known answer in no time. Effect 2 looks
% almost like effect 1 (correlation about 0.98): liquid bridges beside cohesion,
% and each knows the other as its sibling.
%
% See also: diagnoseMatrices

function lab = standInGap (curvature, seed)
  if nargin < 1
    curvature = 0.3;
  end
  if nargin < 2
    seed = 11;
  end
  restore = seedRandom (seed);
  law = drawLaw (curvature);
  lab.noiseSd = 0.15 + 0.1 * rand (1, 24);
  lab.problem = describe (lab.noiseSd, law);
  lab.means = @(theta, phi) results (law, theta, phi);
  lab.plan = @(n0, nk) planOf (lab, n0, nk);
end

% 4 benches: drum (6), collapse (6), discharge (6), shear and heap (6). A row of
% sees says how well each bench sees an effect.
function law = drawLaw (curvature)
  law.bench = kron (1:4, ones (1, 6));
  sees = [3, 2, 1, 3; 3, 2, 1, 3; 1, 0.5, 3, 1; 0.5, 1, 2, 1; 1, 1, 3, 0.5; ...
          1, 2, 1, 0.5; 0.5, 2, 2, 0; 3, 0.3, 0, 1];
  law.slope = 2.5 * randn (4, 24);
  law.bend = curvature * randn (4, 24);
  law.cross = curvature * randn (6, 24);
  law.effect = 0.6 * randn (8, 24) .* sees(:, law.bench);
  law.effect(2, :) = law.effect(1, :) + 0.18 * law.effect(2, :);
  law.mixed = curvature * randn (8, 4, 24);
  law.dead = curvature * [1, 1, 1, 0, 0, 0, 1, 0];
  law.middle = 10 + 10 * rand (1, 24);
  law.gain = 0.15 * (law.bench == 3);
  law.bias = 2.5 * (law.bench == 1);
end

function Z = results (law, theta, phi)
  x = 2 * theta - 1;
  pairs = nchoosek (1:4, 2);
  Z = law.middle + x * law.slope + (x.^2 - 1 / 3) * law.bend + ...
      (x(:, pairs(:, 1)) .* x(:, pairs(:, 2))) * law.cross;
  for k = 1:8
    f = phi(:, k) + law.dead(k) * (phi(:, k).^2 - phi(:, k));
    tilt = x * squeeze (law.mixed(k, :, :));
    Z = Z + f .* (law.effect(k, :) + tilt);
  end
  Z = Z + phi(:, 9) .* (Z .* law.gain) + phi(:, 10) .* law.bias;
end

function problem = describe (noiseSd, law)
  names = {'cohesion', 'liquid', 'wallAdhesion', 'spread', 'size', ...
           'stiffness', 'drag', 'tilt'};
  siblings = [{{'liquid'}, {'cohesion'}}, repmat({{}}, 1, 6)];
  for k = 1:8
    effects(k) = struct ('name', names{k}, 'variables', {names(k)}, ...
                         'neutral', 0, 'limits', [0.1; 1], ...
                         'siblings', {siblings{k}}, ...
                         'laboratory', false, 'offset', [], 'matrix', []);
  end
  effects(9) = struct ('name', 'balanceGain', 'variables', {{}}, ...
                       'neutral', [], 'limits', zeros (2, 0), ...
                       'siblings', {{}}, 'laboratory', true, 'offset', [], ...
                       'matrix', diag (law.gain));
  effects(10) = struct ('name', 'cameraRoll', 'variables', {{}}, ...
                        'neutral', [], 'limits', zeros (2, 0), ...
                        'siblings', {{}}, 'laboratory', true, ...
                        'offset', law.bias, 'matrix', []);
  problem = struct ('value', NaN (1, 24), 'sd', noiseSd, ...
                    'bench', law.bench, ...
                    'limits', [zeros(1, 4); ones(1, 4)], 'effects', effects);
  problem.benchNames = {'drum', 'collapse', 'discharge', 'shear'};
  problem.names = {'friction', 'wallFriction', 'rolling', 'restitution'};
  problem.series = kron (1:8, ones (1, 3));
  problem.coordinate = repmat ([10, 30, 50], 1, 8);
end

function data = planOf (lab, n0, nk)
  data.X = randomLattice (n0, 4);
  phi = zeros (n0, 10);
  for k = 1:8
    points = randomLattice (nk, 5);
    data.X = [data.X; points(:, 1:4)];
    extra = zeros (nk, 10);
    extra(:, k) = 0.1 + 0.9 * points(:, 5);
    phi = [phi; extra];
  end
  data.E = phi(:, 1:8);
  data.Z = lab.means (data.X, phi);
  data.Z = data.Z + lab.noiseSd .* randn (size (data.Z));
  data.replicate = ones (rows (data.X), 1);
end

%!test
%! % same laboratory each time, random state untouched
%! rand ('twister', 5);
%! a = standInGap ();
%! first = rand ();
%! rand ('twister', 5);
%! assert (rand (), first);
%! theta = [0.2, 0.4, 0.6, 0.8];
%! b = standInGap ();
%! assert (a.means (theta, zeros (1, 10)), b.means (theta, zeros (1, 10)));
%!test
%! lab = standInGap (0);
%! s = @(k) lab.means (0.5 * ones (1, 4), (1:10) == k) ...
%!          - lab.means (0.5 * ones (1, 4), zeros (1, 10));
%! assert (s(1) * s(2)' / norm (s(1)) / norm (s(2)) > 0.9);
%! data = lab.plan (20, 3);
%! assert (size (data.Z), [44, 24]);

% SPDX-License-Identifier: GPL-3.0-only
