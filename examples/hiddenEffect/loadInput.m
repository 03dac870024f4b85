% LOADINPUT  A material whose grains stick, looked at with a model without glue.
%
% CALL: [Input, optim, modelVars, assign, paramLims] = loadInput ()
%
% The "measured" values below were made by the same benches with cohesion
% switched on (README.md says how strong), another packing and measurement
% noise. They are simulated, not measured. The model that is calibrated here
% knows friction, rolling friction and density only. diagnoseGap.m has to find
% out. The heap is held out: it is never fitted.
%
% See also: diagnoseGap, loadEffects

function [Input, optim, modelVars, assign, paramLims] = loadInput ()
  Input.model = {'Collapse', 'Shear', 'Heap'};
  Input.cpu = [1, 1, 1];
  Input.maxCPU = 2;
  Input.numOfSam = 30;
  Input.seed = 1;
  Input.maxNewRuns = 600;               % 200 sets on three benches

  optim.targetVal{1} = [689.59, 0.08054, 0.049771, 0.032815, 23.198, 0.22484];
  optim.targetStd{1} = [4, 3e-4, 4e-4, 4e-4, 0.3, 0.003];
  optim.targetName{1} = {'bulkDensity', 'runOut', 'heightBack', ...
                         'heightFoot', 'collapseSlope', 'spreadTime'};
  optim.tolRes{1} = 0.02 * ones (1, 6);
  optim.role{1} = repmat ({'calibrate'}, 1, 6);

  optim.targetVal{2} = [35.719, 0.4124, 663.64, 690.13];
  optim.targetStd{2} = [1.5, 0.006, 4, 4];
  optim.targetName{2} = {'intercept', 'friction', 'densityLow', 'densityHigh'};
  optim.tolRes{2} = [0.1, 0.02, 0.02, 0.02];
  optim.role{2} = repmat ({'calibrate'}, 1, 4);

  optim.targetVal{3} = [33.929, 0.020002, 0.015084, -0.00020022];
  optim.targetStd{3} = [0.5, 3e-4, 1e-4, 3e-4];
  optim.targetName{3} = {'heapSlope', 'heapHeight', 'massOnPlate', 'offset'};
  optim.tolRes{3} = [0.02, 0.02, 0.02, 0.9];
  optim.role{3} = repmat ({'holdout'}, 1, 4);

  modelVars.readTime = 0.4;             % s, of the shear cell

  assign = {'densityP', 'coefFrictionPP', 'coefFrictionPW', ...
            'coefRollingFrictionPP'};
  paramLims = [1000, 0.2, 0.2, 0.01; ...
               1600, 0.7, 0.7, 0.1];
end
