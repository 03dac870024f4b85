% LOADINPUT  A column collapse in YADE, calibrated on one of LIGGGHTS.
%
% CALL: [Input, optim, modelVars, assign, paramLims] = loadInput ()
%
% The targets are simulated, not measured: means of three runs of the bench
% Collapse in LIGGGHTS with densityP 1080 kg/m3, coefFrictionPP 0.36 and
% coefRollingFrictionPP 0.09, with the standard errors of such means. They are
% those of examples/fourBenches.
%
% See also: DEcalioc

function [Input, optim, modelVars, assign, paramLims] = loadInput ()
  Input.model{1} = 'YadeCollapse';
  Input.cpu(1) = 1;
  Input.maxCPU = 2;
  Input.numOfSam = 10;

  % density (kg/m3), run-out (m), two heights (m), slope (deg), time (s)
  optim.targetVal{1} = [590.64, 0.081847, 0.04544, 0.030069, 20.031, 0.24174];
  optim.targetStd{1} = [2, 0.0012, 0.00051, 0.00019, 0.41, 0.0031];
  optim.targetName{1} = {'bulkDensity', 'runOut', 'heightBack', ...
                         'heightFoot', 'collapseSlope', 'spreadTime'};
  optim.role{1} = {'calibrate', 'calibrate', 'calibrate', 'calibrate', ...
                   'holdout', 'holdout'};
  optim.tolRes{1} = [0.015, 0.05, 0.04, 0.04, 0.06, 0.06];
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
