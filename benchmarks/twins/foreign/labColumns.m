% LABCOLUMNS  Foreign laboratory: collapsing columns, a heap, shear, pouring.
%
% CALL: SPEC = labColumns (VARY, CHANGE)
%
%   VARY  handle, x = VARY (x): constants a little different
%   CHANGE  struct: where the benches stand otherwise, see foreignLab
%   SPEC  struct, see foreignLab
%
% Run-out of columns of five aspect ratios by power laws with a kink that moves
% with cohesion, time of spreading by free fall, pouring by fall through air.
% Six parameters, twelve effects, 28 results. Scatter follows the result, with
% heavy tails.
%
% See also: foreignLab, bulkLaws

function spec = labColumns (vary, change)
  c = struct ('base', vary (0.28), 'slide', vary (0.35), 'soon', vary (0.3), ...
              'roll', vary (0.35), 'turn', vary (0.15), ...
              'factor', vary (2.1), 'kink', vary (2.2), 'time', vary (3.1), ...
              'stick', vary (40), 'pack', vary (0.04), 'thrown', vary (25));
  c.aspect = [0.6, 1.2, 2.4, 4.8, 8];
  c.load = [300, 900, 1800];
  c.fall = [0.1, 0.3, 0.6];
  c = mergeFields (c, change);
  spec.name = 'columns';
  spec.parameters = {'friction', 0.2, 0.9; 'rolling', 0, 0.35; ...
                     'wallFriction', 0.1, 0.7; 'restitution', 0.2, 0.9; ...
                     'density', 2200, 2800; 'modulus', 6, 8};
  both = {'cohesion', 'liquid'};
  spec.effects = {'cohesion', 0, [0; 6e4], both(2); ...
                  'liquid', 0, [0; 0.02], both(1); ...
                  'shape', 1, [1; 1.6], {}; ...
                  'wallAdhesion', 0, [0; 6e4], {}; ...
                  'drag', 0, [0; 2], {}; ...
                  'meanSize', 1, [0.85; 1.2], {}; ...
                  'tilt', 0, [-2; 2], {}; ...
                  'vibration', 0, [0; 2.5], {}; ...
                  'sizeSpread', 0, [0; 0.2], {}};
  spec.bench = [ones(1, 15), 2 * ones(1, 4), 3 * ones(1, 6), 4 * ones(1, 3)];
  spec.benchNames = {'columns', 'heap', 'shear', 'pouring'};
  spec.series = [ones(1, 5), 2 * ones(1, 5), 3 * ones(1, 5), zeros(1, 4), ...
                 4 * ones(1, 3), 5 * ones(1, 3), 6 * ones(1, 3)];
  spec.coordinate = [c.aspect, c.aspect, c.aspect, zeros(1, 4), c.load, ...
                     c.load, c.fall];
  isWeighed = [zeros(1, 17), 1, 0, zeros(1, 3), ones(1, 3), zeros(1, 3)];
  spec.laboratory = {'heightBias', ...
                     1.5 * [zeros(1, 5), ones(1, 5), zeros(1, 6), 1, ...
                            zeros(1, 11)], [], false; ...
                     'timeOffset', 0.03 * (spec.series == 3), [], false; ...
                     'massGain', [], 0.04 * diag(isWeighed), false};
  spec.law = @(P, E) results (c, P, E);
  spec.relative = [0.03 * ones(1, 5), 0.02 * ones(1, 5), 0.02 * ones(1, 5), ...
                   0.025, 0.02, 0.02, 0, 0.025 * ones(1, 3), ...
                   0.006 * ones(1, 3), 0.03 * ones(1, 3)];
  spec.floor = [0.5 * ones(1, 5), 0.2 * ones(1, 5), 0.002 * ones(1, 5), ...
                0, 0, 0, 0.8, 8 * ones(1, 3), zeros(1, 6)];
  spec.isLevel = true;
  spec.df = 5;
  spec.rho = 0.4;
  spec.precision = 0.7;
end

function Z = results (c, P, E)
  laws = bulkLaws ();
  s = sticking (P, E);
  inside = laws.reposeTangent (P.friction, P.rolling, c) + 0.12 * s.long;
  grain = givenField (E, 'meanSize', 1);
  solid = 0.61 - 0.05 * tanh (P.rolling / 0.15) + ...
          c.pack * expm1 (-P.friction / 0.4) - 0.025 * s.both + ...
          0.015 * s.long + 0.015 * s.free + 0.02 * s.spread;
  density = P.density .* solid;
  plate = density .* (0.7 + 0.3 * grain);
  Z = [columns(c, s, P, inside, grain), heap(s, P, inside, plate), ...
       shear(c, s, P, inside, density), pouring(c, s, P, inside)];
end

function s = sticking (P, E)
  laws = bulkLaws ();
  pull = laws.bondPull (givenField (E, 'cohesion', 0) / 6e4 .* ...
                        (10.^(7 - P.modulus)).^0.1, 0.15, 0.6);
  s.pull = pull .* (2500 ./ P.density);
  s.wet = laws.bridgePull (givenField (E, 'liquid', 0) / 0.02, 0.25) .* ...
          (2500 ./ P.density);
  s.both = s.pull + 0.9 * s.wet;
  s.long = tanh (3 * (givenField (E, 'shape', 1) - 1));
  s.wall = laws.bondPull (givenField (E, 'wallAdhesion', 0) / 6e4, 0.2, 0.7);
  s.free = laws.shakenShare (givenField (E, 'vibration', 0), 0.9);
  s.tilt = givenField (E, 'tilt', 0);
  s.drag = givenField (E, 'drag', 0);
  s.spread = givenField (E, 'sizeSpread', 0);
end

function Z = columns (c, s, P, inside, grain)
  laws = bulkLaws ();
  factor = max (0.3, c.factor - 1.1 * inside) .* ...
           (1 + 0.15 * P.restitution) .* (1 - 0.12 * P.wallFriction - ...
                                          0.1 * s.wall);
  kink = c.kink * (1 + 0.25 * s.both + 0.1 * s.wall);
  slowing = laws.fallSlowing (0.04 * c.aspect, s.drag);
  reach = laws.runOutLength (c.aspect, factor, kink) .* slowing.^2 .* ...
          (1 - 0.2 * s.both + 0.15 * s.free) .* ...
          (1 + 1.2 * tand (s.tilt)) - ...
          0.5 * (grain - 1);
  stays = min (c.aspect, (0.75 + 0.3 * inside) .* c.aspect.^(1 / 3)) .* ...
          (1 + 0.12 * s.both - 0.1 * s.free - 0.8 * tand (s.tilt) + ...
           0.06 * P.wallFriction + 0.05 * s.wall);
  time = c.time * sqrt (0.04 * c.aspect / 9.81) ./ slowing .* ...
         (1 + 0.1 * P.friction - 0.12 * s.both + 0.1 * s.free + ...
          0.06 * s.long);
  Z = [40 * reach, 40 * stays, time];
end

function Z = heap (s, P, inside, density)
  still = inside + 0.18 * s.both - 0.12 * s.free;
  mass = density / 1500 .* (50 + 40 * still + 25 * s.wet + 12 * s.pull + ...
                            15 * s.wall .* P.wallFriction);
  Z = [atand(still), 35 * still .* (1 - 0.05 * P.restitution), mass, ...
       60 * tand(s.tilt) ./ still];
end

function Z = shear (c, s, P, inside, density)
  tau = c.stick * s.both + c.load .* inside .* (1 + 0.08 * s.pull);
  soft = 0.03 * 10.^(7 - P.modulus).^0.5;
  Z = [tau, density .* (1 - soft .* expm1 (-c.load / 800))];
end

function Z = pouring (c, s, P, inside)
  laws = bulkLaws ();
  speed = laws.fallSlowing (c.fall, s.drag) .* sqrt (2 * 9.81 * c.fall);
  Z = 30 ./ inside + c.thrown * P.restitution.^1.5 .* speed.^0.8 .* ...
      (1 - 0.5 * s.both ./ (0.5 + speed)) .* (1 - 0.25 * s.long);
end

%!shared lab, at
%! lab = foreignLab (3);
%! at = @(k, s) lab.means (0.5 * ones (1, 6), s * ((1:12) == k));
%!test % drag slows tall columns and long falls most; tilt has a sign
%! none = at (5, 0);
%! ratio = at (5, 1) ./ none;
%! assert (all (diff (ratio(1:5)) < 0) && all (ratio(1:5) < 1));
%! assert (all (diff (ratio(26:28)) < 0));
%! assert (at (7, 1)(19) > 0 && at(7, -1)(19) < 0);
%! assert (at (7, 1)(1) > none(1) && at(7, -1)(1) < none(1));
%!test % effects of the laboratory are what their description says
%! assert (at (10, -1) - at (10, 0), -lab.problem.effects(10).offset, 1e-9);
%! assert (at (12, 1)(18) / at (12, 0)(18), 1.04, 1e-12);
%!test % cohesion: nothing up to its dead zone; run-out falls, heights rise
%! assert (at (1, 0.1), at (1, 0));
%! change = at (1, 1) - at (1, 0);
%! assert (all (change([1:4, 11:15]) < 0) && all (change(7:10) > 0));

% SPDX-License-Identifier: GPL-3.0-only
