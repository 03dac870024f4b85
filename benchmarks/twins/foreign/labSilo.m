% LABSILO  Foreign laboratory: a silo with five openings, and a shear cell.
%
% CALL: SPEC = labSilo (VARY, CHANGE)
%
%   VARY  handle, x = VARY (x): constants a little different
%   CHANGE  struct: where the benches stand otherwise, see foreignLab
%   SPEC  struct, see foreignLab
%
% Rates by Beverloo with jamming, stress by Janssen, shear by Mohr and Coulomb.
% Cohesion and liquid bridges look alike but for the slope of shear. Scatter
% grows with the result and has heavy tails.
%
% See also: foreignLab, bulkLaws

function spec = labSilo (vary, change)
  c = struct ('C', vary (0.55), 'k', vary (1.3), 'jam', vary (4), ...
              'arch', vary (0.0016), 'K', vary (0.4), 'stick', vary (45), ...
              'base', vary (0.3), 'slide', vary (0.35), 'soon', vary (0.3), ...
              'roll', vary (0.35), 'turn', vary (0.18));
  c.opening = [16, 20, 25, 31, 38] / 1000;
  c.depth = [0.1, 0.2, 0.4, 0.8];
  c.load = [200, 500, 1000, 2000];
  c = mergeFields (c, change);
  spec.name = 'silo';
  spec.parameters = {'friction', 0.2, 0.8; 'rolling', 0.02, 0.4; ...
                     'wallFriction', 0.1, 0.6; 'restitution', 0.2, 0.8};
  both = {'cohesion', 'liquid'};
  spec.effects = {'cohesion', 0, [0; 6e4], both(2); ...
                  'liquid', 0, [0; 0.02], both(1); ...
                  'wallAdhesion', 0, [0; 6e4], {}; ...
                  'meanSize', 1, [0.85; 1.2], {}; ...
                  'opening', 1, [0.94; 1.06], {}; ...
                  'vibration', 0, [0; 3], {}; ...
                  'moistDensity', 1, [0.93; 1.1], {}; ...
                  'sizeSpread', 0, [0; 0.2], {}};
  spec.bench = [ones(1, 6), 2 * ones(1, 5), 3 * ones(1, 4)];
  spec.benchNames = {'silo', 'stress', 'shear'};
  spec.series = [ones(1, 5), 0, 2 * ones(1, 4), 0, 3 * ones(1, 4)];
  spec.coordinate = [c.opening, 0, c.depth, 0, c.load];
  weighed = [ones(1, 5), zeros(1, 5), 1, zeros(1, 4)];
  spec.laboratory = {'balanceGain', [], 0.06 * diag(weighed), false};
  spec.law = @(P, E) results (c, P, E);
  spec.relative = [0.03 * ones(1, 5), 0, 0.02 * ones(1, 4), 0.006, ...
                   0.025 * ones(1, 4)];
  spec.floor = [0.001 * ones(1, 5), 0.6, 5 * ones(1, 4), 0, 8 * ones(1, 4)];
  spec.isLevel = true;
  spec.df = 4;
  spec.rho = 0.3;
  spec.precision = 0.6;
end

function Z = results (c, P, E)
  laws = bulkLaws ();
  pull = laws.bondPull (givenField (E, 'cohesion', 0) / 6e4, 0.2, 0.7);
  wet = laws.bridgePull (givenField (E, 'liquid', 0) / 0.02, 0.3);
  wall = laws.bondPull (givenField (E, 'wallAdhesion', 0) / 6e4, 0.2, 0.7);
  free = laws.shakenShare (givenField (E, 'vibration', 0), 0.8);
  spread = givenField (E, 'sizeSpread', 0);
  grain = 0.003 * givenField (E, 'meanSize', 1) .* (1 - 0.5 * spread.^2);
  weight = givenField (E, 'moistDensity', 1);
  solid = 0.62 - 0.05 * tanh (P.rolling / 0.15) + ...
          0.04 * expm1 (-P.friction / 0.4) - 0.02 * pull - 0.018 * wet + ...
          0.012 * free + 0.02 * spread + 0.012 * P.restitution;
  density = 2500 * weight .* solid;
  inside = laws.reposeTangent (P.friction, P.rolling, c);
  arch = c.arch * (pull + 0.9 * wet) ./ weight .* (1 + P.rolling) + ...
         0.0004 * wall;
  law = struct ('C', c.C * (1 + 0.3 * exp (-P.friction / 0.3)), ...
                'k', c.k + 0.6 * tanh (P.rolling / 0.2), ...
                'jam', c.jam * (1 - 0.5 * free));
  opening = c.opening .* givenField (E, 'opening', 1);
  rates = laws.dischargeRate (opening - arch, grain, density, law);
  angle = atand (inside + 0.2 * (pull + wet) - 0.12 * free - ...
                 0.1 * P.restitution);
  muK = P.wallFriction .* c.K .* (1.3 - 0.6 * P.friction) .* ...
        (1 - 0.35 * free);
  stress = laws.wallStress (c.depth, density, 0.2, muK, 55 * wall + 12 * pull);
  shear = c.stick * (pull + 1.1 * wet) + ...
          c.load .* inside .* (1 + 0.07 * pull);
  Z = [rates, angle, stress, density, shear];
end

%!shared lab, theta
%! lab = foreignLab (1);
%! theta = 0.5 * ones (1, 4);
%!test % signs at full strength: cohesion slows all rates, the smallest opening
%! % most; it lifts shear; below its dead zone nothing happens at all
%! at = @(k, s) lab.means (theta, s * ((1:9) == k));
%! none = at (1, 0);
%! share = at (1, 1)(1:5) ./ none(1:5);
%! assert (all (share < 1) && all (diff (share) > 0));
%! assert (all (at (1, 1)(12:15) > none(12:15)));
%! assert (at (1, 0.15), none);
%! assert (at (6, 0.3), none);
%! assert (all (at (4, 1)(1:5) < none(1:5)) && at(4, 1)(12) == none(12));
%! assert (at (9, -1)(1:5), 0.94 * none(1:5), 1e-12);

% SPDX-License-Identifier: GPL-3.0-only
