% LOADINPUT  Case of the model @MODEL@: a measured curve and one value.
%
% CALL: [Input, optim, modelVars, assign, paramLims] = loadInput ()
%
% What was measured stands in measured.csv: the profile of the heap, and the
% mass on the plate. As they stand, its values are what the model gave with
% coefFrictionPP 0.45 and coefRollingFrictionPP 0.12 (mean of 12 packings). Put
% your own in their place. docs/inputs.md describes every field. The command
% decalioc check lists all mistakes and says what a calibration will cost.

function [Input, optim, modelVars, assign, paramLims] = loadInput ()
  % --- 1  models --------------------------------------------------------
  Input.model{1} = '@MODEL@';
  Input.cpu(1) = 1;                 % CPUs of a run
  Input.maxCPU = nproc ();          % CPUs of all runs together
  Input.numOfSam = 10;              % runs of the first plan
  Input.seed = 1;                   % same seed, same calibration

  % --- 2  targets: measured.csv -----------------------------------------
  optim.maxFunEvals = 30;                   % sets run after the plan, at most

  % --- 3  variables of data.head ----------------------------------------
  modelVars.densityP = 1200;                % kg/m3, fixed

  assign = {'coefFrictionPP', 'coefRollingFrictionPP'};
  paramLims = [0.2, 0.02; ...               % lower limits
               0.8, 0.30];                  % upper limits
end
