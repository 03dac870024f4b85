% COSTFUNCTION  Residuals of a parameter set; edit it where yours differ.
%
% CALL: RESIDUAL = costFunction (PARAMS, EVALUATEFUNC, VARARGIN)
%
%   PARAMS        d x 1 parameter set, in the order of assign
%   EVALUATEFUNC  function handle: results of the models, one row a target
%   VARARGIN      handed on to EVALUATEFUNC; DEcalioc gives its case here
%   RESIDUAL      one row a target, model by model in the order of
%                 optim.targetVal or measured.csv, then any number of rows of
%                 preferences
%
% The rows of the targets are brought to zero. The rows below them (here: the
% Rayleigh time step) only choose among the sets that meet the targets.
%
% See also: loadInput, costInput, evaluateKriging, evaluateDEM

function residual = costFunction (params, evaluateFunc, varargin)
  result = evaluateFunc (params, varargin);
  given = costInput (varargin);

  % first part: relative difference of results and measured values
  residual = (result(:, 1) - given.value) ./ given.scale;

  % second part: a preference for a large time step
  modelVars = assignParams (given.modelVars, params, given.names);
  if given.WRL ~= 0 && isfield (modelVars, 'RLTS')
    RLTS = getMinMaxRayleigh (modelVars, given.names, given.limits);
    span = max (RLTS.max - RLTS.min, eps (RLTS.max));
    residual(end + 1, 1) = given.WRL * (RLTS.max - modelVars.RLTS) / span;
  end
end

%!test
%! residual = costFunction ([650; 0.5; 0.5; 0.05; 0.05], ...
%!                          @(p, varargin) [404; 0.024]);
%! assert (residual(1:2), [0.01; -0.04], 1e-12);
%! assert (residual(3) > 0 && residual(3) < 0.5);
%!test
%! % the case that is handed on counts, not the file
%! Case = readyCase ();
%! residual = costFunction ([1; 2], @(p, varargin) [404; 0.025; 3], Case);
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (Case.folder, 's');
%! assert (residual, [0.01; 0; 0], 1e-12);
%!test
%! % columns, model by model, and no wish for a large time step
%! folder = tempname ();
%! mkdir (folder);
%! writeAtomic (fullfile (folder, 'loadInput.m'), ...
%!   ["function [Input, optim, modelVars, assign, paramLims] = ", ...
%!    "loadInput ()\n", ...
%!    "Input = struct ();\noptim.targetVal = {[1; 2], [4; 8]};\n", ...
%!    "modelVars = struct ();\nassign = {'a'};\nparamLims = [0; 1];\nend\n"]);
%! here = cd (folder);
%! clear loadInput
%! residual = costFunction (0.5, @(p, varargin) [1; 2; 4; 10]);
%! cd (here);
%! clear loadInput
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (folder, 's');
%! assert (residual, [0; 0; 0; 0.25], 1e-12);
