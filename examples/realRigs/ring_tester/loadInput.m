% LOADINPUT  A commercial ring shear tester: a reference, another series.
%
% CALL: [Input, optim, modelVars, assign, paramLims] = loadInput ()
%
% The bench Shear stands for it, with its runs of examples/hiddenEffect (runs.csv) and
% whatever these have of effects; none is added.
%
% See also: loadEffects, diagnoseGap

function [Input, optim, modelVars, assign, paramLims] = loadInput ()
  Input.model = {'Shear'};
  Input.cpu = 1;
  Input.maxCPU = 1;
  Input.numOfSam = 20;
  Input.seed = 1;
  Input.maxNewRuns = 0;

  optim.maxFunEvals = 1;

  modelVars = struct ();

  assign = {'densityP', 'coefFrictionPP', 'coefFrictionPW', ...
            'coefRollingFrictionPP'};
  paramLims = [1000, 0.2, 0.2, 0.01; ...
               1600, 0.7, 0.7, 0.1];
end
