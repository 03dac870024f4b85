% LABDRUMS  Foreign laboratory: a drum at six speeds, a heap and a tilting box.
%
% CALL: SPEC = labDrums (VARY, CHANGE)
%
%   VARY  handle, x = VARY (x): constants a little different
%   CHANGE  struct: where the benches stand otherwise, see foreignLab
%   SPEC  struct, see foreignLab
%
% Slopes by Froude number with a kink where grains are thrown; what sticks fades
% with speed. Tilt and camera roll both turn the slopes, liquid and charge both
% stick. Plain normal scatter.
%
% See also: foreignLab, bulkLaws

function spec = labDrums (vary, change)
  c = struct ('base', vary (0.32), 'slide', vary (0.3), 'soon', vary (0.3), ...
              'roll', vary (0.3), 'turn', vary (0.15), 'rise', vary (0.8), ...
              'power', vary (0.55), 'lift', vary (1.2), 'from', vary (0.09), ...
              'fade', vary (0.06), 'stick', vary (0.2));
  c.speed = [1, 2, 3, 4.5, 6, 8];
  c = mergeFields (c, change);
  spec.name = 'drums';
  spec.parameters = {'friction', 0.15, 0.9; 'rolling', 0, 0.3; ...
                     'restitution', 0.2, 0.9};
  spec.effects = {'liquid', 0, [0; 0.02], {'charge'}; ...
                  'charge', 0, [0; 1], {'liquid'}; ...
                  'shape', 1, [1; 1.6], {}; ...
                  'tilt', 0, [-2; 2], {}; ...
                  'fill', 1, [0.85; 1.15], {}; ...
                  'drag', 0, [0; 0.6], {}};
  spec.bench = [ones(1, 12), 2 * ones(1, 6)];
  spec.benchNames = {'drum', 'heap'};
  spec.series = [ones(1, 6), 2 * ones(1, 6), zeros(1, 6)];
  spec.coordinate = [c.speed, c.speed, zeros(1, 6)];
  roll = [2 * ones(1, 6), zeros(1, 8), -0.4, 0, 0, 0];
  roll(13) = 0.7;
  spec.laboratory = {'speedError', [], 0.25 * turning(c.speed, 18), true; ...
                     'cameraRoll', roll, [], false};
  spec.law = @(P, E) results (c, P, E);
  spec.relative = [0.015 * ones(1, 6), 0.02 * ones(1, 6), 0.02, 0.02, 0, ...
                   0.015, 0.015, 0.02];
  spec.floor = [zeros(1, 14), 0.6, 0, 0, 0];
  spec.isLevel = false;
  spec.df = Inf;
  spec.rho = 0.2;
  spec.precision = 1;
end

% Matrix that turns results into speed times their slope over speed, by the
% parabola through three neighbours, for the two series of the drum.
function matrix = turning (speed, T)
  n = numel (speed);
  matrix = zeros (T);
  for i = 1:n
    at = min (max (i, 2), n - 1) + (-1:1);
    x = speed(at) - speed(i);
    weight = [1, 1, 1; x; x.^2] \ [0; 1; 0];
    matrix(at, i) = speed(i) * weight;
    matrix(n + at, n + i) = speed(i) * weight;
  end
end

function Z = results (c, P, E)
  laws = bulkLaws ();
  wet = laws.bridgePull (givenField (E, 'liquid', 0) / 0.02, 0.3);
  charge = laws.bridgePull (givenField (E, 'charge', 0), 0.9);
  long = tanh (3 * (givenField (E, 'shape', 1) - 1));
  tilt = givenField (E, 'tilt', 0);
  fill = givenField (E, 'fill', 1);
  slow = 1 - laws.fallSlowing (0.05, givenField (E, 'drag', 0));
  speed = c.speed .* (1 + 0.25 * givenField (E, 'speedError', 0));
  froude = speed.^2 * 0.05 / 9.81;
  rest = laws.reposeTangent (P.friction, P.rolling, c) + 0.12 * long;
  hold = c.stick * (wet + 0.85 * charge .* (1 + 0.3 * P.friction));
  law = struct ('rise', c.rise * (0.5 + P.friction ./ (0.3 + P.friction)), ...
                'power', c.power, 'from', c.from, ...
                'lift', c.lift * (1 - 0.5 * P.restitution));
  tangent = laws.drumTangent (rest, froude, law) + hold ./ (1 + froude / c.fade);
  slope = atand (tangent) + tilt + 8 * slow .* sqrt (froude);
  level = 20 * fill.^0.7 .* (1 + 0.35 * froude .* (1 + P.restitution)) .* ...
          (1 + 0.12 * (wet + 0.8 * charge) + 0.05 * long) + ...
          3 * P.rolling + 3 * max (0, froude - c.from) .* P.friction;
  still = rest + 0.6 * hold;
  heap = [atand(still), 30 * still ./ (1 + 0.2 * P.restitution), ...
          60 * tand(tilt) ./ still, ...
          120 * (1 + 0.3 * still + 0.25 * wet + 0.15 * charge) .* ...
          (1 - 0.06 * long)];
  box = [atand(1.08 * still) + tilt, ...
         atand(0.2 + 0.5 * tanh (P.friction / 0.5) + 0.1 * charge) + tilt];
  Z = [slope, level, heap, box];
end

%!shared lab, at
%! lab = foreignLab (2);
%! at = @(k, s) lab.means (0.5 * ones (1, 3), s * ((1:8) == k));
%!test % steeper with speed; what sticks counts most at low speed; tilt is
%! % geometry: the drum as much as the box
%! none = at (1, 0);
%! assert (all (diff (none(1:6)) > 0));
%! change = at (1, 1) - none;
%! assert (all (change(1:6) > 0) && all (diff (change(1:6)) < 0));
%! assert (at (4, -1)([1, 6, 17]) - none([1, 6, 17]), [-2, -2, -2], 1e-9);
%!test % a faster drum: its matrix is right to first order (1 % of the range)
%! step = 0.02;
%! none = at (7, 0);
%! matrix = lab.problem.effects(7).matrix;
%! linear = step * none * matrix;
%! assert (at (7, step) - none, linear, 0.15 * max (abs (linear)));

% SPDX-License-Identifier: GPL-3.0-only
