% LOADINPUT  Columns of beads in liquid that are lifted: a reference, four series.
%
% CALL: [Input, optim, modelVars, assign, paramLims] = loadInput ()
%
% The model has no liquid: liquidShare of the weight and liquidDrag stand for it.
% How fast the cylinder was lifted is not told.
%
% See also: loadEffects, diagnoseGap

function [Input, optim, modelVars, assign, paramLims] = loadInput ()
  Input.model = {'Columns8', 'Columns6'};
  Input.cpu = [1, 1];
  Input.maxCPU = 1;
  Input.numOfSam = 36;
  Input.seed = 1;
  Input.timeout = 120;
  Input.maxNewRuns = 0;

  optim.maxFunEvals = 20;

  modelVars = struct ();

  assign = {'slidingBeads', 'coefRollingFrictionPP', 'liquidDrag', ...
            'liquidShare', 'liftSpeed'};
  paramLims = [0.05, 0.005, 0, 0.0, 0.15; ...
               0.60, 0.200, 8, 0.4, 0.80];
end
