% LOADINPUT  What has changed since the material was dry?
%
% CALL: [Input, optim, modelVars, assign, paramLims] = loadInput ()
%
% measured.csv has the column condition: dry is the reference, moist and wet are
% what changed. All simulated, not measured (makeTargets.m). The model that is
% calibrated lacks what all three conditions have: clumps, and another law of
% rolling friction. runs.csv is that of ../hiddenEffect.
%
% See also: diagnoseGap, loadEffects

function [Input, optim, modelVars, assign, paramLims] = loadInput ()
  Input.model = {'Collapse', 'Shear', 'Heap'};
  Input.cpu = [1, 1, 1];
  Input.maxCPU = 2;
  Input.numOfSam = 30;
  Input.seed = 1;
  Input.maxNewRuns = 0;                 % runs.csv alone
  optim = struct ();
  modelVars.readTime = 0.4;             % s, of the shear cell
  assign = {'densityP', 'coefFrictionPP', 'coefFrictionPW', ...
            'coefRollingFrictionPP'};
  paramLims = [1000, 0.2, 0.2, 0.01; ...
               1600, 0.7, 0.7, 0.1];
end
