% LABTAPS  Foreign laboratory to develop on: tapping, a penetrometer, a cone.
%
% CALL: SPEC = labTaps (VARY, CHANGE)
%
%   VARY  handle, x = VARY (x): constants a little different
%   CHANGE  struct: where the benches stand otherwise, see foreignLab
%   SPEC  struct, see foreignLab
%
% Density over the logarithm of taps, force of a penetrometer as a power of
% depth. Twelve results on two benches, plain normal scatter.
%
% See also: foreignLab, bulkLaws

function spec = labTaps (vary, change)
  c = struct ('base', vary (0.3), 'slide', vary (0.3), 'soon', vary (0.3), ...
              'roll', vary (0.35), 'turn', vary (0.2), 'gap', vary (0.1), ...
              'set', vary (20), 'step', vary (0.35), 'power', vary (1.3), ...
              'force', vary (3));
  c.taps = [0, 10, 30, 100, 300, 1000];
  c.depth = [10, 20, 40];
  c = mergeFields (c, change);
  spec.name = 'taps';
  spec.parameters = {'friction', 0.2, 0.8; 'rolling', 0, 0.4; ...
                     'restitution', 0.2, 0.9};
  spec.effects = {'cohesion', 0, [0; 6e4], {'charge'}; ...
                  'charge', 0, [0; 1], {'cohesion'}; ...
                  'shape', 1, [1; 1.6], {}; ...
                  'sizeSpread', 0, [0; 0.25], {}; ...
                  'tapForce', 1, [0.6; 1.4], {}};
  spec.bench = [ones(1, 6), 2 * ones(1, 6)];
  spec.benchNames = {'tapping', 'probe'};
  spec.series = [ones(1, 6), 2 * ones(1, 3), 0, 0, 0];
  spec.coordinate = [log1p(c.taps), c.depth, 0, 0, 0];
  weighed = [ones(1, 6), zeros(1, 5), 1];
  spec.laboratory = {'balanceGain', [], 0.03 * diag(weighed), false; ...
                     'depthBias', [], probing(c.depth), true};
  spec.law = @(P, E) results (c, P, E);
  spec.relative = [0.006 * ones(1, 6), 0.03 * ones(1, 3), 0.015, 0.02, 0.02];
  spec.floor = zeros (1, 12);
  spec.isLevel = false;
  spec.df = Inf;
  spec.rho = 0.2;
  spec.precision = 0.8;
end

% The force at a depth that is 1.5 mm off, by the power between neighbours.
function matrix = probing (depth)
  matrix = zeros (12);
  for i = 1:3
    matrix(6 + i, 6 + i) = 1.5 * 1.3 / depth(i);
  end
end

function Z = results (c, P, E)
  laws = bulkLaws ();
  pull = laws.bondPull (foreignValue (E, 'cohesion', 0) / 6e4, 0.15, 0.7);
  charge = laws.bridgePull (foreignValue (E, 'charge', 0), 0.8);
  long = tanh (3 * (foreignValue (E, 'shape', 1) - 1));
  spread = foreignValue (E, 'sizeSpread', 0);
  tap = foreignValue (E, 'tapForce', 1);
  off = 1.5 * foreignValue (E, 'depthBias', 0);
  both = pull + 0.9 * charge;
  inside = laws.reposeTangent (P.friction, P.rolling, c) + 0.15 * long;
  loose = 0.6 - 0.05 * tanh (P.rolling / 0.15) + ...
          0.05 * expm1 (-P.friction / 0.4) - 0.04 * both + 0.02 * long + ...
          0.15 * spread.^2;
  gap = c.gap * (1 + 0.5 * P.friction + 0.6 * both + 0.3 * long);
  share = laws.tappedShare (c.taps, c.set * (1 + both) ./ tap.^2, ...
                            c.step * (1.2 - 0.4 * P.restitution));
  density = 2500 * (loose + gap .* share);
  force = c.force * (1 + 3 * inside.^2) .* (c.depth + off).^c.power / 10 .* ...
          (1 + 0.3 * both + 0.25 * long - 0.7 * spread);
  still = inside + 0.2 * both;
  heap = [atand(still), 40 * still ./ (1 + 0.2 * P.restitution), ...
          90 * loose / 0.6 .* (1 + 0.2 * charge)];
  Z = [density, force, heap];
end

%!shared lab, at
%! lab = foreignLab ('develop', 2);
%! at = @(k, s) lab.means (0.5 * ones (1, 3), s * ((1:7) == k));
%!test % taps compact, harder taps sooner but not the first density
%! none = at (5, 0);
%! assert (all (diff (none(1:6)) > 0));
%! assert (at (5, 1)(1), none(1));
%! assert (all (at (5, 1)(2:6) > none(2:6)));
%! assert (all (at (5, -1)(2:6) < none(2:6)));
%! assert (all (at (7, 1)(7:9) > none(7:9)));
