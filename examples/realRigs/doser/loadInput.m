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
  Input.numOfSam = 12;
  Input.seed = 1;
  Input.timeout = 1200;
  Input.maxNewRuns = 24;
  Input.store = '../runs';

  optim.maxFunEvals = 1;

  modelVars = struct ();

  assign = {'coefFrictionPW', 'coefRollingFrictionPP', 'screwSolid'};
  paramLims = [0.10, 0.02, 0.06; ...
               0.50, 0.20, 0.20];
end
