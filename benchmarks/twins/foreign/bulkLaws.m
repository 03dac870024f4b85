% BULKLAWS  Laws of bulk solids that the foreign laboratories follow.
%
% CALL: LAWS = bulkLaws ()
%
%   LAWS  struct of handles, a law each; what each takes stands above it
%
% Published laws with thresholds, kinks and saturation, which the diagnosis does
% not know.
%
% See also: foreignLab

function laws = bulkLaws ()
  laws = struct ('bondPull', @bondPull, ...
                 'bridgePull', @bridgePull, ...
                 'dischargeRate', @dischargeRate, ...
                 'drumTangent', @drumTangent, ...
                 'fallSlowing', @fallSlowing, ...
                 'reposeTangent', @reposeTangent, ...
                 'runOutLength', @runOutLength, ...
                 'shakenShare', @shakenShare, ...
                 'slotRate', @slotRate, ...
                 'tappedShare', @tappedShare, ...
                 'wallStress', @wallStress);
end

% How much dry cohesion matters, by its Bond number.
%
%   B = bondPull (STRENGTH, DEAD, HALF)
%
%   STRENGTH  any shape, cohesion energy over its limit
%   DEAD      scalar, below this strength nothing is to be seen
%   HALF      scalar, strength above DEAD (over 1 - DEAD) at which half of what
%             saturates is reached
%   B         same shape, exactly 0 up to DEAD, 1 at STRENGTH 1
%
% The pull-off force of Hertz contacts with SJKR cohesion grows with the cube of
% the cohesion energy density; the bulk feels it from a Bond number of about 0.1
% and saturates when all contacts hold.
function B = bondPull (strength, dead, half)
  x = max (0, (strength - dead) / (1 - dead)).^3;
  B = x * (1 + half^3) ./ (x + half^3);
end

% How much liquid bridges matter: soon, then hardly more.
%
%   B = bridgePull (CONTENT, SOON)
%
%   CONTENT  any shape, liquid content over its limit
%   SOON     scalar, content (over the limit) at which 1 - 1/e is reached
%   B        same shape, exactly 0 at 0, 1 at CONTENT 1
%
% The force of a pendular bridge hardly depends on its volume, so the pull grows
% with the number of bridges: (1 - exp (-c/c0)) / (1 - exp (-1/c0)).
function B = bridgePull (content, soon)
  B = expm1 (-content / soon) / expm1 (-1 / soon);
end

% Mass flow through a round opening, with jamming (Beverloo).
%
%   W = dischargeRate (OPENING, GRAIN, DENSITY, LAW)
%
%   OPENING  n x m, diameter that is left for the flow (m)
%   GRAIN    n x 1, diameter of a grain (m)
%   DENSITY  n x 1, bulk density (kg/m3)
%   LAW      struct of scalars or n x 1: C (about 0.58), k (about 1.4), jam
%            (openings in grains over which jamming fades, about 4)
%   W        n x m (kg/s), 0 where the opening is narrower than k grains
%
% W = C rho sqrt (g) (1 - exp (-(D/d - k) / jam) / 2) (D - k d)^2.5: Beverloo et
% al. 1961; the factor for few grains across as Mankoc et al. 2007.
function W = dischargeRate (opening, grain, density, law)
  free = max (0, opening - law.k .* grain);
  few = 1 - 0.5 * exp (-free ./ grain ./ law.jam);
  W = law.C .* density .* sqrt (9.81) .* few .* free.^2.5;
end

% Tangent of the slope in a turning drum grows with Froude number.
%
%   S = drumTangent (REST, FROUDE, LAW)
%
%   REST    n x 1, tangent at rest
%   FROUDE  n x m or 1 x m, omega^2 R / g
%   LAW     struct of scalars or n x 1: rise (0.9), power (0.5), lift (1.5),
%           from (Froude number above which grains are thrown, 0.08)
%   S       n x m, rest + rise Fr^power + lift max (0, Fr - from)
function S = drumTangent (rest, froude, law)
  S = rest + law.rise .* froude.^law.power + ...
      law.lift .* max (0, froude - law.from);
end

% Speed of a grain that fell through air over that in a vacuum.
%
%   F = fallSlowing (HEIGHT, DRAG)
%
%   HEIGHT  of the fall (m)
%   DRAG    gravity over the square of the terminal velocity (1/m): g / vt^2
%   F       in (0, 1], shape of HEIGHT .* DRAG, exactly 1 without drag
%
% v = vt sqrt (1 - exp (-2 g h / vt^2)) for drag that grows with v^2.
function F = fallSlowing (height, drag)
  x = 2 * height .* drag;
  F = ones (size (x));
  has = x ~= 0;
  F(has) = sqrt (-expm1 (-x(has)) ./ x(has));
end

% Tangent of the angle of repose saturates in both frictions.
%
%   R = reposeTangent (SLIDING, ROLLING, LAW)
%
%   SLIDING, ROLLING  n x 1, coefficients of friction
%   LAW   struct of scalars: base (0.3), slide (0.35), soon (0.25: sliding
%         friction at which 1 - 1/e is reached), roll (0.4), turn (0.15)
%   R     n x 1, base + slide (1 - exp (-mu/soon)) + roll tanh (rolling/turn)
%
% Sliding friction counts little once grains roll instead, and rolling friction
% little once they slide: both saturate (Zhou et al. 2002, Wensrich and
% Katterfeld 2012).
function R = reposeTangent (sliding, rolling, law)
  R = law.base - law.slide * expm1 (-sliding / law.soon) + ...
      law.roll * tanh (rolling / law.turn);
end

% Run-out of a collapsing column: two power laws and a kink.
%
%   L = runOutLength (ASPECT, FACTOR, CRITICAL)
%
%   ASPECT    1 x m or n x m, height over length of the column
%   FACTOR    n x 1, run-out over length at aspect ratio 1 (about 1.2 to 1.8)
%   CRITICAL  n x 1, aspect ratio of the kink (about 2.3)
%   L         n x m, run-out over length
%
% L = f a up to the critical ratio, f ac (a / ac)^(2/3) above: planar columns,
% Lube et al. 2005, Balmforth and Kerswell 2005; the kink made continuous.
function L = runOutLength (aspect, factor, critical)
  ratio = aspect ./ critical;
  L = factor .* critical .* min (ratio, max (ratio, 0).^(2 / 3));
end

% Share of the grains that vibration sets free, from 1 g on.
%
%   S = shakenShare (ACCELERATION, SOON)
%
%   ACCELERATION  any shape, of the vibration over gravity, from 0
%   SOON          scalar, excess over 1 at which 1 - 1/e is reached
%   S             same shape, in [0, 1): exactly 0 up to 1
function S = shakenShare (acceleration, soon)
  S = -expm1 (-max (0, acceleration - 1) / soon);
end

% Mass flow through a slot, a metre long, with a cohesive arch.
%
%   W = slotRate (WIDTH, GRAIN, DENSITY, STRENGTH, LAW)
%
%   WIDTH     1 x m, of the slot (m)
%   GRAIN     n x 1, diameter of a grain (m)
%   DENSITY   n x 1, bulk density (kg/m3)
%   STRENGTH  n x 1, unconfined strength of the material (Pa)
%   LAW       struct C (about 1), k (about 1.4): scalars or n x 1
%   W         n x m (kg/s), 0 where an arch or k grains close the slot
%
% W = C rho sqrt (g) (B - k d - B0)^1.5, with B0 = STRENGTH / (rho g): the slot
% that an arch of this strength can span (Jenike 1964).
function W = slotRate (width, grain, density, strength, law)
  arch = strength ./ (density * 9.81);
  free = max (0, width - law.k .* grain - arch);
  W = law.C .* density .* sqrt (9.81) .* free.^1.5;
end

% Compaction by taps: slow, with the logarithm of their number.
%
%   S = tappedShare (TAPS, TIME, STEP)
%
%   TAPS  1 x m, number of taps from 0
%   TIME  n x 1, taps after which it sets in
%   STEP  n x 1, how much a factor e of taps brings
%   S     n x m, share of the gap to the densest packing that is closed, [0, 1)
%
% S = 1 - 1 / (1 + B log (1 + t / tau)), Knight et al. 1995.
function S = tappedShare (taps, time, step)
  S = 1 - 1 ./ (1 + step .* log1p (taps ./ time));
end

% Vertical stress in a tall silo saturates with depth (Janssen).
%
%   S = wallStress (DEPTH, DENSITY, WIDTH, MUK, COHESION)
%
%   DEPTH     1 x m (m)
%   DENSITY   n x 1, bulk density (kg/m3)
%   WIDTH     scalar, diameter of the silo (m)
%   MUK       n x 1, wall friction times ratio of stresses
%   COHESION  n x 1, stress that sticks to the wall (Pa)
%   S         n x m (Pa), not below 0
%
% S = (rho g - 4 c / D) D / (4 mu K) (1 - exp (-4 mu K z / D)), Janssen 1895,
% with the adhesion of the wall as in Nedderman 1992.
function S = wallStress (depth, density, width, muK, cohesion)
  rate = 4 * muK / width;
  weight = max (0, 9.81 * density - 4 * cohesion / width);
  S = -weight ./ rate .* expm1 (-rate * depth);
end

%!shared laws
%! laws = bulkLaws ();
%!test % dead zone, cubic start, one at full strength, monotone
%! assert (laws.bondPull ([0, 0.1, 0.2], 0.2, 0.6), [0, 0, 0]);
%! assert (laws.bondPull (1, 0.2, 0.6), 1, 1e-12);
%! B = laws.bondPull (0.2 + 0.8 * [0.01, 0.02], 0.2, 0.6);
%! assert (B(2) / B(1), 8, 0.01);
%! assert (all (diff (laws.bondPull (0.3:0.05:1.2, 0.2, 0.6)) > 0));
%!test
%! assert (laws.bridgePull (0, 0.3), 0);
%! B = laws.bridgePull (0:0.25:1, 0.3);
%! assert (B(5), 1, 1e-12);
%! assert (all (diff (B) > 0) && all (diff (B, 2) < 0));
%!shared laws, law
%! laws = bulkLaws ();
%! law = struct ('C', 0.58, 'k', 1.4, 'jam', 4);
%!test % nothing flows below k grains, above it more and more
%! W = laws.dischargeRate ([2, 4.2, 4.3, 10, 20] / 1000, 0.003, 1500, law);
%! assert (W(1:2), [0, 0], 1e-12);
%! assert (W(3) > 0 && all (diff (W(2:5)) > 0));
%!test % wide openings: Beverloo's law
%! W = laws.dischargeRate (0.2, 0.002, 1500, law);
%! assert (W, 0.58 * 1500 * sqrt (9.81) * 0.1972^2.5, 1e-6 * W);
%!test % coarser grains flow slower
%! W = laws.dischargeRate ([1; 1] * 0.02, [0.002; 0.003], 1500, law);
%! assert (W(2) < W(1));
%!test % at rest the angle of repose, then monotone with a kink
%! law = struct ('rise', 0.9, 'power', 0.5, 'lift', 1.5, 'from', 0.08);
%! S = laws.drumTangent (0.5, [0, 0.02, 0.08, 0.2], law);
%! assert (S([1, 3]), 0.5 + 0.9 * sqrt ([0, 0.08]), 1e-12);
%! assert (S(4), 0.5 + 0.9 * sqrt (0.2) + 0.18, 1e-12);
%!test
%! assert (laws.fallSlowing ([0, 1], [3, 0]), [1, 1]);
%! v = laws.fallSlowing (1000, 9.81 / 4^2) * sqrt (2 * 9.81 * 1000);
%! assert (v, 4, 1e-9);
%! assert (all (diff (laws.fallSlowing (0.3, 0:5)) < 0));
%!test % from base to base + slide + roll
%! law = struct ('base', 0.3, 'slide', 0.35, 'soon', 0.25, 'roll', 0.4, ...
%!               'turn', 0.15);
%! assert (laws.reposeTangent ([0; 10], [0; 10], law), [0.3; 1.05], 1e-12);
%! assert (all (diff (laws.reposeTangent ((0:0.1:1)', 0.1, law)) > 0));
%! assert (all (diff (laws.reposeTangent (0.4, (0:0.05:0.4)', law)) > 0));
%!test % linear, then 2/3 power, continuous between
%! L = laws.runOutLength ([0, 1, 2, 2.5, 20], 1.4, 2.5);
%! assert (L(1:4), 1.4 * [0, 1, 2, 2.5], 1e-12);
%! assert (L(5) / L(4), 8^(2 / 3), 1e-12);
%!test
%! S = laws.shakenShare ([0, 0.5, 1, 1.1, 3, 100], 0.8);
%! assert (S(1:3), [0, 0, 0]);
%! assert (all (diff (S(3:6)) > 0));
%! assert (S(6), 1, 1e-12);
%!test % closed by k grains or by an arch of 15 mm, else 3/2 power
%! law = struct ('C', 1, 'k', 1.4);
%! W = laws.slotRate ([0.002, 0.03], 0.002, 1500, 0, law);
%! assert (W, [0, 1500 * sqrt(9.81) * 0.0272^1.5], 1e-9);
%! strong = 1500 * 9.81 * 0.015;
%! W = laws.slotRate ([0.0178, 0.0179], 0.002, 1500, strong, law);
%! assert (W(1), 0, 1e-6);
%! assert (W(2) > 1e-4);
%!test
%! S = laws.tappedShare ([0, 10, 100, 1e4], 10, 0.3);
%! assert (S(1), 0);
%! assert (S(2), 1 - 1 / (1 + 0.3 * log (2)), 1e-12);
%! assert (all (diff (S) > 0) && S(4) < 1);
%!test % at the top as a liquid, deep down at rho g D / (4 mu K)
%! S = laws.wallStress ([1e-4, 0.5, 1, 50], 1500, 0.1, 0.2, 0);
%! assert (S(1), 9.81 * 1500 * 1e-4, 1e-2);
%! assert (S(4), 9.81 * 1500 * 0.1 / 0.8, 1e-9);
%! assert (all (diff (S) > 0));
%!test % enough adhesion carries all
%! assert (laws.wallStress (1, 1500, 0.1, 0.2, 1e3), 0);

% SPDX-License-Identifier: GPL-3.0-only
