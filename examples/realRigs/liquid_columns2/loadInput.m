% LOADINPUT  Columns of beads in liquid under raised gravity: a reference, three series.
%
% CALL: [Input, optim, modelVars, assign, paramLims] = loadInput ()
%
% The model of liquid_columns under 45.2 m/s2. Faster beads feel more of an eddying
% liquid, so its drag may be larger.
%
% See also: loadEffects, diagnoseGap

function [Input, optim, modelVars, assign, paramLims] = loadInput ()
  Input.model = {'Columns8', 'Columns6'};
  Input.cpu = [1, 1];
  Input.maxCPU = 1;
  Input.numOfSam = 20;
  Input.seed = 1;
  Input.timeout = 600;
  Input.maxNewRuns = 110;

  optim.maxFunEvals = 4;

  modelVars = struct ();

  assign = {'slidingBeads', 'coefRollingFrictionPP', 'liquidDrag', ...
            'liquidShare', 'liftSpeed'};
  paramLims = [0.05, 0.005,  0, 0.0, 0.3; ...
               0.60, 0.200, 20, 0.6, 2.0];
end
