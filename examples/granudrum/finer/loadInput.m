% LOADINPUT  The GranuDrum with grains twice too large, coarse runs beside.
%
% CALL: [Input, optim, modelVars, assign, paramLims] = loadInput ()
%
% runs.csv holds the runs of ../runs.csv (grains 3 times too large, the coarse
% level), the one of ../scaleRuns.csv and those that this case added at the
% level that counts. Otherwise as the case in the folder above.
%
% See also: loadEffects, DEcalioc, diagnoseGap

function [Input, optim, modelVars, assign, paramLims] = loadInput ()
  Input.model = {'GranuDrum'};
  Input.cpu = 1;
  Input.maxCPU = 2;
  Input.numOfSam = 12;
  Input.seed = 1;
  Input.maxNewRuns = 0;                 % runs.csv alone
  Input.timeout = 3600;
  Input.coarse{1} = struct ('variable', 'grainScale', 'levels', [3, 2]);
  optim.maxFunEvals = 8;
  optim.correlation = {100};            % mm
  modelVars = struct ();
  assign = {'coefFrictionPP', 'coefRollingFrictionPP', 'drumSolid'};
  paramLims = [0.2, 0.02, 0.21; ...
               1.0, 0.90, 0.29];
end
