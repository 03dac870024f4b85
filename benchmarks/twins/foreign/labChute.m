% LABCHUTE  Foreign laboratory to develop on: a chute, slots and a shear tester.
%
% CALL: SPEC = labChute (VARY, CHANGE)
%
%   VARY  handle, x = VARY (x): constants a little different
%   CHANGE  struct: where the benches stand otherwise, see foreignLab
%   SPEC  struct, see foreignLab
%
% Flow down a chute of five slopes that stops below an angle, slots that an arch
% of cohesive strength closes. Scatter follows the result, with heavy tails.
%
% See also: foreignLab, bulkLaws

function spec = labChute (vary, change)
  c = struct ('base', vary (0.18), 'slide', vary (0.25), 'soon', vary (0.4), ...
              'roll', vary (0.2), 'turn', vary (0.2), 'flow', vary (0.4), ...
              'fade', vary (4), 'C', vary (1), 'k', vary (1.3), ...
              'stick', vary (40));
  c.tangent = tand ([28, 30, 32, 34, 36]);
  c.width = [12, 16, 22, 30] / 1000;
  c.load = [250, 700, 1500];
  c = mergeFields (c, change);
  spec.name = 'chute';
  spec.parameters = {'friction', 0.2, 0.7; 'rolling', 0, 0.3; ...
                     'restitution', 0.2, 0.9; 'wallFriction', 0.1, 0.6};
  spec.effects = {'cohesion', 0, [0; 6e4], {'humidity'}; ...
                  'humidity', 0, [0; 1], {'cohesion'}; ...
                  'meanSize', 1, [0.85; 1.2], {}; ...
                  'tilt', 0, [-1.5; 1.5], {}; ...
                  'vibration', 0, [0; 3], {}; ...
                  'drag', 0, [0; 1], {}; ...
                  'stiffness', 1, [0.4; 4], {}};
  spec.bench = [ones(1, 6), 2 * ones(1, 4), 3 * ones(1, 6)];
  spec.benchNames = {'chute', 'slot', 'tester'};
  spec.series = [ones(1, 5), 0, 2 * ones(1, 4), 3 * ones(1, 3), ...
                 4 * ones(1, 3)];
  spec.coordinate = [c.tangent, 0, c.width, c.load, c.load];
  weighed = [ones(1, 5), 0, ones(1, 4), zeros(1, 3), ones(1, 3)];
  spec.laboratory = {'balanceGain', [], 0.05 * diag(weighed), false};
  spec.law = @(P, E) results (c, P, E);
  spec.relative = [0.04 * ones(1, 5), 0.02, 0.03 * ones(1, 4), ...
                   0.025 * ones(1, 3), 0.006 * ones(1, 3)];
  spec.floor = [0.5 * ones(1, 5), 0, 0.05 * ones(1, 4), 6 * ones(1, 3), ...
                zeros(1, 3)];
  spec.isLevel = true;
  spec.df = 5;
  spec.rho = 0.3;
  spec.precision = 0.7;
end

function Z = results (c, P, E)
  laws = bulkLaws ();
  pull = laws.bondPull (foreignValue (E, 'cohesion', 0) / 6e4, 0.2, 0.6);
  damp = laws.bridgePull (foreignValue (E, 'humidity', 0), 0.4);
  coarse = foreignValue (E, 'meanSize', 1);
  free = laws.shakenShare (foreignValue (E, 'vibration', 0), 1);
  air = 1 - laws.fallSlowing (0.5, foreignValue (E, 'drag', 0));
  soft = log (foreignValue (E, 'stiffness', 1));
  tilt = foreignValue (E, 'tilt', 0);
  inside = laws.reposeTangent (P.friction, P.rolling, c);
  low = inside + 0.05 * (pull + damp) - 0.05 * free;
  law = struct ('low', low, 'high', low + 0.5 + 0.1 * (1 - P.restitution), ...
                'fade', c.fade, 'flow', c.flow * (1 - 0.3 * air) .* ...
                (1 - 0.15 * P.wallFriction));
  slope = tand (atand (c.tangent) + tilt);
  flow = chuteFlow (slope, 12 ./ coarse, law);
  stop = atand (law.low + 0.1) - tilt;
  solid = 0.61 - 0.04 * tanh (P.rolling / 0.15) + ...
          0.04 * expm1 (-P.friction / 0.4) - 0.02 * (pull + damp) + 0.01 * free;
  density = 2500 * solid;
  slots = laws.slotRate (c.width, 0.002 * coarse, density, ...
                         (22 * pull + 20 * damp) .* (1 - 0.5 * free), ...
                         struct ('C', c.C * (1.2 - 0.3 * P.friction - 0.1 * air), ...
                                 'k', c.k + 0.4 * P.rolling + ...
                                 0.3 * P.wallFriction));
  tau = c.stick * (pull + 0.95 * damp) + ...
        c.load .* inside .* (1 + 0.06 * pull);
  pressed = density .* (1 + (0.02 - 0.004 * soft) .* ...
                        log1p (c.load / 400));
  Z = [flow, stop, slots, tau, pressed];
end

% Flow down a rough chute, which stops below a certain angle: TANGENT of its slope
% (1 x m or n x m), DEPTH of the layer in grains (n x 1), LAW as below; Q n x m.
% After Pouliquen 1999: low is the tangent at which a deep layer stops, high that of
% a thin one, fade a depth in grains. The denominator, of the friction law mu (I) of
% Jop et al. 2006, is kept above a tenth of high - low.
function Q = chuteFlow (tangent, depth, law)
  span = law.high - law.low;
  stop = law.low + span .* exp (-depth ./ law.fade);
  Q = law.flow .* depth.^2.5 .* max (0, tangent - stop) ./ ...
      max (0.1 * span, law.high - tangent);
end

%!shared lab, at
%! lab = foreignLab ('develop', 1);
%! at = @(k, s) lab.means (0.5 * ones (1, 4), s * ((1:8) == k));
%!test % steeper, faster; tilt steepens all the same; wide slots flow more
%! none = at (1, 0);
%! assert (all (diff (none(1:5)) > 0) && all (diff (none(7:10)) > 0));
%! assert (all (at (4, 1)(1:5) > none(1:5)));
%! assert (at (4, 1)(6) - none(6), -1.5, 1e-9);
%! assert (at (5, 0.3), none);
%! assert (all (at (2, 1)(7:10) < none(7:10)));
