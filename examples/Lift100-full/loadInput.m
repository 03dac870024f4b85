% LOADINPUT  The minimal working example of the published user document.
%
% CALL: [Input, optim, modelVars, assign, paramLims] = loadInput ()
%
% The container Lift100 at full size with the document's settings: spheres of
% 2 and 3 mm radius rain in for 2 s, rest for 3 s, and what is left after 10 s
% of discharge is weighed. Start it in this folder:
%   octave-cli ../../DEcalioc.m
%
% See also: README.md in this folder, DEMmodels/Lift100/README.md

function [Input, optim, modelVars, assign, paramLims] = loadInput ()

  % --- 1  discrete element model, processors, samples ----------------------
  Input.model{1} = 'Lift100';
  Input.cpu(1) = 1;
  % the document uses 8 processors; never more than there are
  Input.maxCPU = min (8, nproc ());
  Input.numOfSam = 21;
  % s; a run takes about 2 minutes of an idle core
  Input.timeout(1) = 3600;

  % --- 2  targets and stopping ---------------------------------------------
  % bulk density (kg/m3), mass that stays in the container (kg)
  optim.targetVal{1}(1) = 400;
  optim.targetVal{1}(2) = 0.025;
  optim.tolRes{1}(1) = 0.01;
  optim.tolRes{1}(2) = 0.01;
  optim.tolfun = 0.002;
  optim.maxIter = 3;
  optim.maxFunEvals = 40;
  optim.WRL = 0.5;

  % --- 3  model variables, design variables and their limits ---------------
  modelVars.youngsModulusP = 5e6;
  modelVars.poissonsRatioP = 0.3;
  modelVars.youngsModulusW = 210e9;
  modelVars.poissonsRatioW = 0.3;
  modelVars.coefRestitutionPP = 0.6;
  modelVars.coefRestitutionPW = 0.69;
  modelVars.coefRestitutionWW = 0.69;
  modelVars.coefFrictionWW = 0.5;
  modelVars.coefRollingFrictionWW = 0.05;
  modelVars.radiusP = 2e-3;
  modelVars.percentRayleigh = 0.35;
  % full size, filled as published, cut at the height of the document (by
  % itself the model cuts at 50 mm, as the published model files do).
  % useCriteria 1 ends settling and discharge as soon as all is at rest; the
  % two times are then upper limits
  modelVars.scaleP = 1;
  modelVars.fillMethod = 1;
  modelVars.fillHeight = 0.055;
  modelVars.useCriteria = 1;
  modelVars.settleTime = 3;
  modelVars.dischargeTime = 10;

  assign{1} = 'densityP';
  assign{2} = 'coefFrictionPP';
  assign{3} = 'coefFrictionPW';
  assign{4} = 'coefRollingFrictionPP';
  assign{5} = 'coefRollingFrictionPW';
  paramLims = [500, 0.3, 0.3, 0.025, 0.025; ...
               800, 0.7, 0.7, 0.075, 0.075];

end
