% LABCURVE  Foreign laboratory with a curve: emptying bin, drum, shear cell.
%
% CALL: SPEC = labCurve (VARY, RHO)
%
%   VARY  handle, x = VARY (x): constants a little different
%   RHO   scalar in [0, 1), correlation of the errors of neighbours on the curve
%   SPEC  struct, see foreignLab
%
% The mass that has left the bin at 60 times; its errors, of the measurement (as
% declared in gapProblem.covariance) and of the packing, fade along the curve as
% RHO^|i - j|. Scatter is normal and the same along the curve.
%
% See also: foreignLab, emptyingCurve, curveTwins

function spec = labCurve (vary, rho)
  c = struct ('base', vary (0.3), 'slide', vary (0.3), 'soon', vary (0.3), ...
              'roll', vary (0.3), 'turn', vary (0.15), 'C', vary (0.58), ...
              'k', vary (1.4), 'jam', vary (4), 'arch', vary (0.001), ...
              'rise', vary (0.9), 'power', vary (0.5), 'lift', vary (1.5), ...
              'from', vary (0.09), 'stick', vary (40), 'mass', 2.5);
  c.time = 0.4 * (1:60);
  c.speed = [1, 2.5, 4, 6];
  c.load = [300, 800, 1500, 2500];
  spec.name = 'curve';
  spec.parameters = {'friction', 0.2, 0.8; 'rolling', 0, 0.3; ...
                     'restitution', 0.2, 0.9};
  spec.effects = {'cohesion', 0, [0; 6e4], {}; ...
                  'meanSize', 1, [0.85; 1.2], {}; ...
                  'opening', 1, [0.95; 1.05], {}; ...
                  'fill', 1, [0.9; 1.1], {}; ...
                  'tilt', 0, [-2; 2], {}};
  spec.bench = [ones(1, 60), 2 * ones(1, 4), 3 * ones(1, 4)];
  spec.benchNames = {'bin', 'drum', 'shear'};
  spec.series = spec.bench;
  spec.coordinate = [c.time, c.speed, c.load];
  shift = zeros (68);
  shift(1:60, 1:60) = slopeOver (c.time);
  spec.laboratory = {'balanceGain', [], ...
                     0.04 * diag([ones(1, 60), zeros(1, 8)]), false; ...
                     'clockOffset', [], -0.6 * shift, true};
  spec.law = @(P, E) results (c, P, E);
  spec.relative = [zeros(1, 60), 0.015 * ones(1, 4), 0.02 * ones(1, 4)];
  spec.floor = [0.02 * ones(1, 60), zeros(1, 4), 8 * ones(1, 4)];
  spec.isLevel = false;
  spec.df = Inf;
  spec.rho = 0;
  spec.precision = [2.5 * ones(1, 60), ones(1, 8)];
  spec.correlation = eye (68);
  spec.correlation(1:60, 1:60) = rho.^abs ((1:60)' - (1:60));
end

% Matrix that turns values on an even grid into their slope.
function matrix = slopeOver (x)
  n = numel (x);
  matrix = zeros (n);
  for i = 1:n
    at = [max(i - 1, 1), min(i + 1, n)];
    matrix(at, i) = [-1; 1] / diff (x(at));
  end
end

function Z = results (c, P, E)
  pull = bondPull (foreignValue (E, 'cohesion', 0) / 6e4, 0.15, 0.7);
  grain = 0.003 * foreignValue (E, 'meanSize', 1);
  tilt = foreignValue (E, 'tilt', 0);
  late = 0.6 * foreignValue (E, 'clockOffset', 0);
  inside = reposeTangent (P.friction, P.rolling, c);
  still = inside + 0.2 * pull;
  solid = 0.6 - 0.05 * tanh (P.rolling / 0.15) + ...
          0.04 * expm1 (-P.friction / 0.4) - 0.03 * pull;
  law = struct ('C', c.C * (1 + 0.25 * exp(-P.friction / 0.3) + ...
                            0.08 * P.restitution), ...
                'k', c.k + 0.5 * tanh (P.rolling / 0.2), 'jam', c.jam);
  opening = 0.026 * foreignValue (E, 'opening', 1) - c.arch * pull;
  rate = dischargeRate (opening, grain, 2500 * solid, law);
  filled = c.mass * foreignValue (E, 'fill', 1);
  leaves = filled .* (1 - 0.15 * still);
  curve = emptyingCurve (c.time - late, rate, 0.8 * leaves, leaves);
  froude = c.speed.^2 * 0.05 / 9.81;
  turning = struct ('rise', c.rise * (0.6 + 0.5 * P.friction), ...
                    'power', c.power, 'from', c.from, ...
                    'lift', c.lift * (1 - 0.4 * P.restitution));
  slope = atand (drumTangent (inside, froude, turning) + ...
                 0.18 * pull ./ (1 + froude / 0.06)) + tilt;
  shear = c.stick * pull + c.load .* inside;
  Z = [curve, slope, shear];
end

%!shared lab, at
%! lab = foreignLab ('curve', 3);
%! at = @(k, s) lab.means (0.5 * ones (1, 3), s * ((1:7) == k));
%!test % mass only leaves, all laboratories of this kind have the same laws
%! none = at (1, 0);
%! assert (all (diff (none(1:60)) > 0));
%! assert (none, foreignLab ('curve', 1).bare (0.5 * ones (1, 3)));
%!test % declared covariance: 0.9 between neighbours, 0.81 the one after
%! C = lab.gapProblem.covariance;
%! assert ([C(1, 2), C(1, 3)] / C(1, 1), [0.9, 0.81], 1e-12);
%! assert (C(60, 61), 0);
%!test % errors of 4000 measurements: correlation of neighbours within 4
%! % standard errors, 0.003 each
%! randn ('twister', 2);
%! y = lab.measure (0.5 * ones (4000, 3), zeros (4000, 7));
%! assert (corr (y(:, 20), y(:, 21)), 0.9, 0.012);
%!test % a clock that starts late shows less mass, by its matrix
%! change = at (7, 0.1) - at (7, 0);
%! linear = 0.1 * at (7, 0) * lab.gapProblem.effects(7).matrix;
%! assert (change(5:40), linear(5:40), 0.05 * max (abs (linear)));
