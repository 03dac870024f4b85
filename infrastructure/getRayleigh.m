% GETRAYLEIGH  Rayleigh time of spheres, under its published name.
%
% CALL: T = getRayleigh (R, RHO, E, NU)
%
%   R    radius (m)                 all four: scalars or arrays of one size
%   RHO  density (kg/m3)
%   E    Young's modulus (Pa)
%   NU   Poisson's ratio (-)
%   T    Rayleigh time (s), see rayleighTime
%
% See also: rayleighTime, assignParams, getMinMaxRayleigh

function t = getRayleigh (r, rho, E, nu)
  t = rayleighTime (r, rho, E, nu);
end

%!assert (getRayleigh (2e-3, 700, 5e6, 0.3), 1.29521e-4, 1e-9)
