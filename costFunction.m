% COSTFUNCTION  Residuals of a parameter set; edit it where yours differ.
%
% CALL: RESIDUAL = costFunction (PARAMS, EVALUATEFUNC, VARARGIN)
%
%   PARAMS        d x 1 parameter set, in the order of assign
%   EVALUATEFUNC  function handle: results of the models, one row a target
%   VARARGIN      handed on to EVALUATEFUNC
%   RESIDUAL      one row a target, in the order of optim.targetVal, then any
%                 number of rows of preferences
%
% The rows of the targets are brought to zero. The rows below them (here: the
% Rayleigh time step) only choose among the sets that meet the targets.
%
% See also: loadInput, evaluateKriging, evaluateDEM

function residual = costFunction (params, evaluateFunc, varargin)
  result = evaluateFunc (params, varargin);
  [~, optim, modelVars, assign, paramLims] = loadInput ();
  targetVal = optim.targetVal;
  if iscell (targetVal)
    targetVal = horzcat (targetVal{:})';
  end

  % first part: relative difference of results and measured values
  residual = (result(:, 1) - targetVal(:)) ./ targetVal(:);

  % second part: a preference for a large time step
  modelVars = assignParams (modelVars, params, assign);
  if optim.WRL ~= 0 && isfield (modelVars, 'RLTS')
    RLTS = getMinMaxRayleigh (modelVars, assign, paramLims);
    span = max (RLTS.max - RLTS.min, eps (RLTS.max));
    residual(end + 1, 1) = optim.WRL * (RLTS.max - modelVars.RLTS) / span;
  end
end

%!test
%! residual = costFunction ([650; 0.5; 0.5; 0.05; 0.05], ...
%!                          @(p, varargin) [404; 0.024]);
%! assert (residual(1:2), [0.01; -0.04], 1e-12);
%! assert (residual(3) > 0 && residual(3) < 0.5);
