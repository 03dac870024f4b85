% LOADINPUT  Microcrystalline cellulose in a GranuDrum: two measured surfaces.
%
% CALL: [Input, optim, modelVars, assign, paramLims] = loadInput ()
%
% The targets are in measured.csv: the free surface at 15 rpm (surfaceSlow) and
% 45 rpm (surfaceFast). README.md says where they come from. runs.csv holds the
% runs that were made; with Input.maxNewRuns = 0 no other one is made.
%
% See also: loadEffects, DEcalioc, diagnoseGap

function [Input, optim, modelVars, assign, paramLims] = loadInput ()
  Input.model = {'GranuDrum'};
  Input.cpu = 1;
  Input.maxCPU = 2;
  Input.numOfSam = 12;
  Input.seed = 1;
  Input.replicates = 4;
  Input.maxNewRuns = 70;
  Input.timeout = 3600;

  % 26 runs at most, of two speeds each: 52 runs as ACCES counts them
  optim.maxFunEvals = 14;
  optim.maxIter = 2;

  % 0.7 mm systematic and 0.1 mm random: sd 0.71 mm, and an error that changes
  % by sqrt (2) 0.1 mm over the 2 mm to the next point:
  % 0.71 sqrt (2 (1 - exp (-2 / 100))) = 0.14
  optim.correlation = {100};            % mm

  modelVars.grainScale = 3;

  assign = {'coefFrictionPP', 'coefRollingFrictionPP', 'drumSolid'};
  paramLims = [0.2, 0.02, 0.21; ...
               1.0, 0.90, 0.29];
end
