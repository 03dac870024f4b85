% LOADINPUT  The doser on other days, three sets: a reference and another series each.
%
% CALL: [Input, optim, modelVars, assign, paramLims] = loadInput ()
%
% One form for the sets A, B and C (a folder each, with its measured.csv); they share
% their runs.
%
% See also: loadEffects, diagnoseGap

function [Input, optim, modelVars, assign, paramLims] = loadInput ()
  Input.model = {'ShotDoser'};
  Input.cpu = 1;
  Input.maxCPU = 1;
  Input.numOfSam = 6;
  Input.seed = 1;
  Input.timeout = 900;
  Input.maxNewRuns = 24;
  Input.store = '../runs';

  optim.maxFunEvals = 1;

  modelVars = struct ();

  assign = {'coefFrictionPW', 'coefRollingFrictionPP', 'screwSolid'};
  paramLims = [0.10, 0.02, 0.06; ...
               0.50, 0.20, 0.20];
end
