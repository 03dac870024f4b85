% LOADINPUT  A home-made ring shear cell: a reference, and one other series.
%
% CALL: [Input, optim, modelVars, assign, paramLims] = loadInput ()
%
% See also: loadEffects, diagnoseGap

function [Input, optim, modelVars, assign, paramLims] = loadInput ()
  Input.model = {'RingShear'};
  Input.cpu = 1;
  Input.maxCPU = 1;
  Input.numOfSam = 20;
  Input.seed = 1;
  Input.timeout = 600;
  Input.maxNewRuns = 24;

  optim.maxFunEvals = 20;
  optim.correlation = {0};               % of the two ends of a straight line

  modelVars = struct ();

  assign = {'slidingGrains', 'coefRollingFrictionPP'};
  paramLims = [0.15, 0.01; ...
               0.80, 0.30];
end
