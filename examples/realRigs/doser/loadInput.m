% LOADINPUT  A tube with a screw that doses powder: a reference, other series.
%
% CALL: [Input, optim, modelVars, assign, paramLims] = loadInput ()
%
% One form for the powders P, Q and R (a folder each, with its measured.csv);
% they share their runs.
%
% See also: loadEffects, diagnoseGap

function [Input, optim, modelVars, assign, paramLims] = loadInput ()
  Input.model = {'ScrewDoser'};
  Input.cpu = 1;
  Input.maxCPU = 1;
  Input.numOfSam = 16;
  Input.seed = 1;
  Input.timeout = 300;
  Input.maxNewRuns = 24;
  Input.store = '../runs';

  optim.maxFunEvals = 1;

  modelVars = struct ();

  assign = {'slidingGrains', 'coefRollingFrictionPP', 'screwSolid'};
  paramLims = [0.20, 0.02, 0.12; ...
               0.80, 0.30, 0.30];
end
