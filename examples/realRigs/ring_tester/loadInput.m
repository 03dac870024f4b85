% LOADINPUT  A commercial ring shear tester: a reference, and one other series.
%
% CALL: [Input, optim, modelVars, assign, paramLims] = loadInput ()
%
% See also: loadEffects, diagnoseGap

function [Input, optim, modelVars, assign, paramLims] = loadInput ()
  Input.model = {'RingTester'};
  Input.cpu = 1;
  Input.maxCPU = 1;
  Input.numOfSam = 8;
  Input.seed = 1;
  Input.timeout = 600;
  Input.maxNewRuns = 12;

  optim.maxFunEvals = 1;

  modelVars = struct ();

  assign = {'slidingGrains', 'coefRollingFrictionPP'};
  paramLims = [0.15, 0.01; ...
               0.80, 0.30];
end
