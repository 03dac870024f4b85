% LOADINPUT  Plastic spheres that run out of a slot bin: a measured curve.
%
% CALL: [Input, optim, modelVars, assign, paramLims] = loadInput ()
%
% The targets are in measured.csv: the discharged share against time. README.md
% says where they come from and what is not known about them. runs.csv holds the
% finished runs; with Input.maxNewRuns = 0 no other one is made.
%
% See also: diagnoseGap, loadEffects

function [Input, optim, modelVars, assign, paramLims] = loadInput ()
  Input.model = {'CentralSlot'};
  Input.cpu = 1;
  Input.maxCPU = 1;
  Input.numOfSam = 8;
  Input.seed = 1;

  % the tolerance of each point is in measured.csv: 2 % of the filled mass
  optim.maxFunEvals = 6;
  optim.maxIter = 1;

  modelVars = struct ();

  assign = {'coefFrictionPP', 'coefRollingFrictionPP'};
  paramLims = [0.2, 0.01; ...
               0.8, 0.15];
end
