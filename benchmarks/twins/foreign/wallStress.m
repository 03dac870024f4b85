% WALLSTRESS  Vertical stress in a tall silo saturates with depth (Janssen).
%
% CALL: S = wallStress (DEPTH, DENSITY, WIDTH, MUK, COHESION)
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
%
% See also: foreignLab

function S = wallStress (depth, density, width, muK, cohesion)
  rate = 4 * muK / width;
  weight = max (0, 9.81 * density - 4 * cohesion / width);
  S = -weight ./ rate .* expm1 (-rate * depth);
end

%!test % at the top as a liquid, deep down at rho g D / (4 mu K)
%! S = wallStress ([1e-4, 0.5, 1, 50], 1500, 0.1, 0.2, 0);
%! assert (S(1), 9.81 * 1500 * 1e-4, 1e-2);
%! assert (S(4), 9.81 * 1500 * 0.1 / 0.8, 1e-9);
%! assert (all (diff (S) > 0));
%!test % enough adhesion carries all
%! assert (wallStress (1, 1500, 0.1, 0.2, 1e3), 0);
