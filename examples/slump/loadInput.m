% LOADINPUT  A small model of four files: a column of spheres that falls.
%
% CALL: [Input, optim, modelVars, assign, paramLims] = loadInput ()
%
% docs/extend.md explains the files of the model.
%
% See also: DEcalioc

function [Input, optim, modelVars, assign, paramLims] = loadInput ()
  Input.model{1} = 'Slump';
  Input.cpu(1) = 1;
  Input.maxCPU = 2;
  Input.numOfSam = 8;

  optim.targetVal{1} = [0.0195, 0.0057];    % m, measured
  optim.tolRes{1} = [0.05, 0.05];
  optim.targetName{1} = {'run-out', 'height'};
  optim.tolfun = 0.002;
  optim.maxIter = 3;
  optim.maxFunEvals = 20;
  optim.WRL = 0;

  modelVars.percentRayleigh = 0.3;
  modelVars.radiusP = 1.5e-3;
  modelVars.densityP = 2500;
  modelVars.youngsModulusP = 5e6;
  modelVars.poissonsRatioP = 0.3;
  assign = {'coefFrictionPP', 'coefRollingFrictionPP'};
  paramLims = [0.2, 0.02; 0.8, 0.3];
end
