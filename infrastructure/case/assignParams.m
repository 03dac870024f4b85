% ASSIGNPARAMS  Puts a parameter set into the model variables.
%
% CALL: MODELVARS = assignParams (MODELVARS, PARAMS, ASSIGN)
%
%   MODELVARS  scalar struct of model variables
%   PARAMS     1 x d or d x 1, one value a design variable
%   ASSIGN     cell of d names of design variables
%
% Where radius, density, Young's modulus and Poisson's ratio are all known,
% RLTS, the Rayleigh time (s), is added, and with percentRayleigh also
% SIMTS = percentRayleigh * RLTS, the time step (s).
%
% Errors: DEcalioc:assignParams:badShape
%
% See also: getRayleigh, writeHead

function modelVars = assignParams (modelVars, params, assign)
  if numel (params) ~= numel (assign)
    error ('DEcalioc:assignParams:badShape', ...
           ['assignParams: PARAMS must hold one value for each of the ' ...
            '%d names in assign, got %d.'], numel (assign), numel (params));
  end
  for k = 1:numel (assign)
    modelVars.(assign{k}) = params(k);
  end
  needed = {'radiusP', 'densityP', 'youngsModulusP', 'poissonsRatioP'};
  if all (isfield (modelVars, needed))
    values = cellfun (@(name) modelVars.(name), needed, ...
                      'UniformOutput', false);
    modelVars.RLTS = getRayleigh (values{:});
    if isfield (modelVars, 'percentRayleigh')
      modelVars.SIMTS = modelVars.percentRayleigh * modelVars.RLTS;
    end
  end
end

%!test
%! v = struct ('radiusP', 2e-3, 'youngsModulusP', 5e6, ...
%!             'poissonsRatioP', 0.3, 'percentRayleigh', 0.35);
%! v = assignParams (v, [700; 0.5], {'densityP', 'coefFrictionPP'});
%! assert (v.coefFrictionPP, 0.5);
%! assert (v.SIMTS, 0.35 * getRayleigh (2e-3, 700, 5e6, 0.3), eps);
%!assert (assignParams (struct ('b', 1), 3, {'a'}), struct ('b', 1, 'a', 3))
%!error id=DEcalioc:assignParams:badShape
%! assignParams (struct (), 1:2, {'a'});

% SPDX-License-Identifier: GPL-3.0-only
