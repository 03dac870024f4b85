% LABBENCHTOP  Foreign laboratory: five small tests with two results each.
%
% CALL: SPEC = labBenchtop (VARY, CHANGE)
%
%   VARY  handle, x = VARY (x): constants a little different
%   CHANGE  struct: where the benches stand otherwise, see foreignLab
%   SPEC  struct, see foreignLab
%
% Cone, funnel, shear cell, tapping, drum: ten results, three parameters, so
% little is left over that shows a gap. Heavy tails, scatter the same all over.
%
% See also: foreignLab

function spec = labBenchtop (vary, change)
  c = struct ('base', vary (0.3), 'slide', vary (0.35), 'soon', vary (0.25), ...
              'roll', vary (0.4), 'turn', vary (0.2), 'C', vary (0.58), ...
              'k', vary (1.4), 'jam', vary (3.5), 'arch', vary (0.0014), ...
              'stick', vary (60), 'dense', vary (0.13), 'rise', vary (1), ...
              'power', vary (0.6), 'lift', vary (1.5), 'from', vary (0.1));
  c.width = [0.015, 0.025];
  c.load = [400, 1600];
  c.taps = [0, 200];
  c.speed = [2, 6];
  c = mergeFields (c, change);
  spec.name = 'benchtop';
  spec.parameters = {'friction', 0.2, 0.8; 'rolling', 0, 0.4; ...
                     'wallFriction', 0.1, 0.6};
  spec.effects = {'cohesion', 0, [0; 6e4], {'humidity'}; ...
                  'humidity', 0, [0; 1], {'cohesion'}; ...
                  'meanSize', 1, [0.8; 1.25], {}; ...
                  'restitution', 1, [1; 4], {}; ...
                  'tilt', 0, [-2; 2], {}};
  spec.bench = kron (1:5, [1, 1]);
  spec.benchNames = {'cone', 'funnel', 'shear', 'tapping', 'drum'};
  spec.series = [0, 0, 1, 1, 2, 2, 3, 3, 4, 4];
  spec.coordinate = [0, 0, c.width, c.load, c.taps, c.speed];
  weighed = [0, 1, 1, 1, 0, 0, 1, 1, 0, 0];
  spec.laboratory = {'balanceGain', [], 0.05 * diag(weighed), false};
  spec.law = @(P, E) results (c, P, E);
  spec.relative = [0.02, 0.015, 0.025, 0.02, 0.03, 0.02, 0.006, 0.005, ...
                   0.015, 0.02];
  spec.floor = zeros (1, 10);
  spec.isLevel = false;
  spec.df = 4;
  spec.rho = 0.25;
  spec.precision = 0.8;
end

function Z = results (c, P, E)
  laws = bulkLaws ();
  pull = laws.bondPull (givenField (E, 'cohesion', 0) / 6e4, 0.1, 0.8);
  damp = laws.bridgePull (givenField (E, 'humidity', 0), 0.5);
  coarse = givenField (E, 'meanSize', 1);
  tilt = givenField (E, 'tilt', 0);
  dull = 1 - 1 ./ givenField (E, 'restitution', 1);
  both = pull + 0.85 * damp;
  inside = laws.reposeTangent (P.friction, P.rolling, c);
  still = inside + 0.22 * both .* (1 + 0.5 * P.rolling) ./ coarse;
  loose = 0.6 - 0.05 * tanh (P.rolling / 0.15) + ...
          0.05 * expm1 (-P.friction / 0.4) - 0.05 * both ./ coarse.^2;
  law = struct ('C', c.C * (1 + 0.25 * exp(-P.friction / 0.3)) .* ...
                (1 - 0.12 * P.wallFriction), ...
                'k', c.k + 0.5 * tanh (P.rolling / 0.2), 'jam', c.jam);
  opening = c.width - c.arch * both;
  rate = laws.dischargeRate (opening, 0.0025 * coarse, 2500 * loose, law);
  gain = c.dense * (1 + 0.6 * both + 0.3 * P.rolling);
  density = 2500 * (loose + gain .* laws.tappedShare (c.taps, 15, 0.4));
  tau = c.stick * (pull + 0.95 * damp) + ...
        c.load .* inside .* (1 + 0.05 * pull);
  froude = c.speed.^2 * 0.06 / 9.81;
  turning = struct ('rise', c.rise * (0.6 + 0.5 * P.friction), ...
                    'power', c.power, 'from', c.from, ...
                    'lift', c.lift * (1 + 0.3 * dull));
  slope = atand (laws.drumTangent (inside, froude, turning) + ...
                 0.2 * both ./ (1 + froude / 0.06) + ...
                 0.05 * P.wallFriction) + tilt;
  cone = [atand(still - 0.02 * dull), 80 * (1 + 0.4 * still) .* loose / 0.6];
  Z = [cone, rate, tau, density, slope];
end

%!shared lab, at
%! lab = foreignLab (4);
%! at = @(k, s) lab.means (0.5 * ones (1, 3), s * ((1:6) == k));
%!test % tilt turns the drum alone; taps compact; coarse grains flow slower
%! change = at (5, 1) - at (5, 0);
%! assert (change, [zeros(1, 8), 2, 2], 1e-9);
%! none = at (1, 0);
%! assert (none(8) > none(7));
%! assert (all (at (3, 1)(3:4) < none(3:4)));
%! assert (all (at (3, -1)(3:4) > none(3:4)));
%! assert (at (1, 0.1), none);

% SPDX-License-Identifier: GPL-3.0-only
