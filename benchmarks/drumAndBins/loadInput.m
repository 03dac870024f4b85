% LOADINPUT  Drum and slot bins together: the case of the stored campaign.
%
% CALL: [Input, optim, modelVars, assign, paramLims] = loadInput ()
%
% Nothing is measured here. The targets are simulated placeholders, so that the
% case loads: means of two packings without any effect (README.md has the call).
% A study of the diagnosis puts its own targets in their place, drawn from the
% runs in storedRuns.csv.
%
% targetStd is a measurement uncertainty as large as the scatter of one run over
% packings (DEMmodels/Drum/README.md and, for the bins, the later figures of
% DEMmodels/README.md; remaining1 the larger of the two there).
%
% See also: campaign, loadEffects

function [Input, optim, modelVars, assign, paramLims] = loadInput ()
  Input.model = {'Drum', 'SlotBin'};
  Input.cpu = [1, 1];
  Input.maxCPU = 2;
  Input.numOfSam = 45;
  Input.seed = 1;

  % slope (deg), curvature (1/m), height (m) at 2, 4 and 8 rad/s
  optim.targetVal{1} = [35.244, -2.6823, -0.0046649, ...
                        38.812, 1.1901, -0.0047286, ...
                        47.168, 3.8289, -0.0030816];
  optim.targetStd{1} = [0.54, 1.2, 4.5e-4, ...
                        0.60, 0.84, 3.9e-4, ...
                        1.2, 0.61, 4.4e-4];
  optim.targetName{1} = {'drumSlope1', 'curvature1', 'height1', ...
                         'drumSlope2', 'curvature2', 'height2', ...
                         'drumSlope3', 'curvature3', 'height3'};
  optim.tolRes{1} = [0.03, 0.9, 0.2, 0.03, 0.9, 0.2, 0.05, 0.4, 0.3];
  optim.role{1} = repmat ({'calibrate'}, 1, 9);

  % rate (kg/s), remaining mass (kg), slope (deg), for two slots
  optim.targetVal{2} = [0.055978, 0.0075147, 35.083, ...
                        0.10294, 0.0044653, 38.725];
  optim.targetStd{2} = [0.0019, 3.7e-4, 2.7, 0.0046, 3.3e-4, 3.1];
  optim.targetName{2} = {'rate1', 'remaining1', 'binSlope1', ...
                         'rate2', 'remaining2', 'binSlope2'};
  optim.tolRes{2} = [0.07, 0.11, 0.16, 0.1, 0.17, 0.17];
  optim.role{2} = repmat ({'calibrate'}, 1, 6);

  % all other variables as in data.head of the benches
  modelVars = struct ();

  assign = {'densityP', 'coefFrictionPP', 'coefFrictionPW', ...
            'coefRollingFrictionPP'};
  paramLims = [1000, 0.2, 0.2, 0.01; ...
               1600, 0.7, 0.7, 0.1];
end
