% LOADINPUT  Calibration on four benches at once: heap, shear cell, column
% collapse and slot bins.
%
% CALL: [Input, optim, modelVars, assign, paramLims] = loadInput ()
%
% The targets are SYNTHETIC, not measured: means of three simulations with
% densityP 1080 kg/m3, coefFrictionPP 0.36, coefRollingFrictionPP 0.09 and seeds
% that the calibration does not use. So one can see whether it finds them.
% targetStd is the standard error of such a mean (noise of a run / sqrt (3));
% the tolerances are about three times the noise of a run.

function [Input, optim, modelVars, assign, paramLims] = loadInput ()
  Input.model = {'Heap', 'Shear', 'Collapse', 'SlotBin'};
  Input.cpu = [1, 1, 1, 1];
  Input.maxCPU = 2;
  Input.numOfSam = 12;
  Input.seed = 1;

  % Heap: slope (deg), height (m), mass on the plate (kg), offset (m)
  optim.targetVal{1} = [31.013, 0.01702, 0.0095786, -7.3218e-05];
  optim.targetStd{1} = [0.4, 0.00021, 0.00015, 5.2e-05];
  optim.targetName{1} = {'heapSlope', 'heapHeight', 'heapMass', 'heapOffset'};
  optim.role{1} = {'calibrate', 'holdout', 'calibrate', 'holdout'};
  optim.tolRes{1} = [0.06, 0.06, 0.08, 0.9];

  % Shear: intercept (Pa), friction (-), densities (kg/m3)
  optim.targetVal{2} = [18.522, 0.41152, 573.71, 588.72];
  optim.targetStd{2} = [5, 0.01, 1.1, 2.1];
  optim.targetName{2} = {'shearIntercept', 'shearFriction', ...
                         'shearDensityLow', 'shearDensityHigh'};
  optim.role{2} = {'holdout', 'calibrate', 'calibrate', 'holdout'};
  optim.tolRes{2} = [0.9, 0.15, 0.02, 0.02];

  % Collapse: density (kg/m3), run-out, two heights (m), slope (deg), time (s)
  optim.targetVal{3} = [590.64, 0.081847, 0.04544, 0.030069, 20.031, 0.24174];
  optim.targetStd{3} = [2, 0.0012, 0.00051, 0.00019, 0.41, 0.0031];
  optim.targetName{3} = {'columnDensity', 'runOut', 'heightBack', ...
                         'heightFoot', 'depositSlope', 'spreadTime'};
  optim.role{3} = {'calibrate', 'calibrate', 'calibrate', 'holdout', ...
                   'holdout', 'holdout'};
  optim.tolRes{3} = [0.02, 0.08, 0.06, 0.06, 0.1, 0.1];

  % SlotBin: rate (kg/s), remaining mass (kg), slope (deg), for two slots
  optim.targetVal{4} = [0.047542, 0.006249, 33.222, ...
                        0.086046, 0.0035105, 36.018];
  optim.targetStd{4} = [0.00069, 0.00024, 1.7, 0.0014, 0.0001, 1.7];
  optim.targetName{4} = {'rate20', 'remaining20', 'slope20', 'rate30', ...
                         'remaining30', 'slope30'};
  optim.role{4} = {'calibrate', 'calibrate', 'holdout', 'holdout', ...
                   'holdout', 'holdout'};
  optim.tolRes{4} = [0.08, 0.15, 0.25, 0.08, 0.15, 0.25];

  optim.tolfun = 0.002;
  optim.maxIter = 3;
  optim.maxFunEvals = 16;
  optim.WRL = 0;

  modelVars.radiusP = 2e-3;             % m
  modelVars.youngsModulusP = 5e6;       % Pa
  modelVars.poissonsRatioP = 0.3;

  assign = {'densityP', 'coefFrictionPP', 'coefRollingFrictionPP'};
  paramLims = [900, 0.2, 0.02; 1400, 0.7, 0.2];
end
