% ASSIGNPARAMS  Puts a parameter set into the model variables.
%
% CALL: MODELVARS = assignParams (MODELVARS, PARAMS, ASSIGN)
%
%   MODELVARS  scalar struct of model variables; RLTS and SIMTS (s) are added
%              where they can be worked out, see designVariables
%   PARAMS     1 x d or d x 1, one value per design variable
%   ASSIGN     cell of d names of design variables
%
% See also: designVariables, getRayleigh, writeHead

function modelVars = assignParams (modelVars, params, assign)
  modelVars = designVariables (modelVars, params, assign);
end

%!assert (assignParams (struct ('b', 1), 3, {'a'}), struct ('b', 1, 'a', 3))
