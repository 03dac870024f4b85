% GETRAYLEIGH  Rayleigh time of spheres.
%
% CALL: T = getRayleigh (R, RHO, E, NU)
%
%   R    radius (m)                 all four: scalars or arrays of one size
%   RHO  density (kg/m3)
%   E    Young's modulus (Pa)
%   NU   Poisson's ratio (-)
%   T    Rayleigh time (s) = pi r sqrt (rho / G) / (0.1631 nu + 0.8766), with
%        the shear modulus G = E / (2 (1 + nu))
%
% Source: the user document of DEcalioc (2017), section 4.3.
%
% See also: assignParams, getMinMaxRayleigh

function t = getRayleigh (r, rho, E, nu)
  G = E ./ (2 * (1 + nu));
  t = pi * r .* sqrt (rho ./ G) ./ (0.1631 * nu + 0.8766);
end

%!test
%! % by hand: G = 5e6 / 2.6, sqrt (700 / G) = 0.0190788,
%! % 0.1631 nu + 0.8766 = 0.92553
%! assert (getRayleigh (2e-3, 700, 5e6, 0.3), 1.29521e-4, 1e-9);
%!assert (size (getRayleigh ([1; 2] * 1e-3, 700, 5e6, 0.3)), [2, 1])

% SPDX-License-Identifier: GPL-3.0-only
