% LOADINPUT  Columns of beads that collapse: a reference, three other series.
%
% CALL: [Input, optim, modelVars, assign, paramLims] = loadInput ()
%
% The targets are in measured.csv (writeMeasured.m): series 1 is the reference,
% series2 to series4 what may have changed. README.md says where they come from.
% storedRuns.csv holds the runs that were made.
%
% See also: loadEffects, DEcalioc, diagnoseGap

function [Input, optim, modelVars, assign, paramLims] = loadInput ()
  Input.model = {'Beads8', 'Beads4'};
  Input.cpu = [1, 1];
  Input.maxCPU = 2;
  Input.numOfSam = 24;
  Input.seed = 1;
  Input.replicates = 2;
  Input.timeout = 900;
  Input.maxNewRuns = 0;                 % runs.csv alone

  optim.maxFunEvals = 16;
  optim.maxIter = 1;

  % the scatter of a trial's profile is alike over 0.15 of the tank
  optim.correlation = {0.15, 0.15};

  modelVars = struct ();

  % gateTime: seconds in which the gate goes up by the height of the column
  assign = {'slidingGrains', 'slidingWalls', 'coefRollingFrictionPP', ...
            'gateTime'};
  paramLims = [0.10, 0.10, 0.02, 0.02; ...
               0.80, 0.80, 0.30, 0.25];
end
