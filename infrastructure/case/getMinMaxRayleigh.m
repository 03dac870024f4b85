% GETMINMAXRAYLEIGH  Range of the Rayleigh time over the parameter space.
%
% CALL: RLTS = getMinMaxRayleigh (MODELVARS)
%       RLTS = getMinMaxRayleigh (MODELVARS, ASSIGN, PARAMLIMS)
%
%   MODELVARS  scalar struct of model variables
%   ASSIGN     cell of d names of design variables    (default: loadInput)
%   PARAMLIMS  2 x d, lower and upper limits          (default: loadInput)
%   RLTS       struct with the fields min and max (s)
%
% The Rayleigh time rises with radius, density and Poisson's ratio and falls
% with Young's modulus, so the two ends are corners of the box.
%
% See also: getRayleigh, costFunction

function RLTS = getMinMaxRayleigh (modelVars, assign, paramLims)
  if nargin < 3
    raw = readInput ();
    modelVars = raw.modelVars;
    assign = raw.assign;
    paramLims = raw.paramLims;
  end
  r = ends ('radiusP', modelVars, assign, paramLims);
  rho = ends ('densityP', modelVars, assign, paramLims);
  E = flipud (ends ('youngsModulusP', modelVars, assign, paramLims));
  nu = ends ('poissonsRatioP', modelVars, assign, paramLims);
  t = getRayleigh (r, rho, E, nu);
  RLTS = struct ('min', t(1), 'max', t(2));
end

function limits = ends (name, modelVars, assign, paramLims)
  isDesign = strcmp (assign, name);
  if any (isDesign)
    limits = paramLims(:, isDesign);
  else
    limits = [1; 1] * modelVars.(name);
  end
end

%!test
%! v = struct ('radiusP', 2e-3, 'youngsModulusP', 5e6, 'poissonsRatioP', 0.3);
%! RLTS = getMinMaxRayleigh (v, {'densityP'}, [500; 800]);
%! assert (RLTS.min, getRayleigh (2e-3, 500, 5e6, 0.3), eps);
%! assert (RLTS.max, getRayleigh (2e-3, 800, 5e6, 0.3), eps);

% SPDX-License-Identifier: GPL-3.0-only
