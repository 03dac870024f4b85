% LOADINPUT  Case of the model @MODEL@: targets and parameters.
%
% CALL: [Input, optim, modelVars, assign, paramLims] = loadInput ()
%
% As it stands, it calibrates two friction coefficients against values that the
% model gave with coefFrictionPP 0.45 and coefRollingFrictionPP 0.12 (mean of 20
% packings). Put your own measured values in their place. docs/inputs.md
% describes every field. The command decalioc check lists all mistakes and says
% what a calibration will cost.

function [Input, optim, modelVars, assign, paramLims] = loadInput ()
  % --- 1  models --------------------------------------------------------
  Input.model{1} = '@MODEL@';
  Input.cpu(1) = 1;                 % CPUs of a run
  Input.maxCPU = nproc ();          % CPUs of all runs together
  Input.numOfSam = 4;               % first plan: parameters + 2, see form.csv
  Input.seed = 1;                   % same seed, same calibration

  % --- 2  targets, in the order of getResults ---------------------------
  % Or as a table: rename measured-example.csv to measured.csv (three trials of
  % the angle are in it) and take the first four of these lines out.
  optim.targetName{1} = {'angle of repose', 'mass on plate', 'apex height'};
  optim.targetVal{1} = [30.5, 0.0120, 0.0173];    % deg, kg, m
  optim.tolRes{1} = [0.06, 0.04, 0.08];     % relative
  optim.role{1} = {'', '', 'holdout'};      % the apex is only predicted
  optim.maxFunEvals = 30;                   % sets run after the plan, at most

  % --- 3  variables of data.head ----------------------------------------
  modelVars.densityP = 1200;                % kg/m3, fixed

  assign = {'coefFrictionPP', 'coefRollingFrictionPP'};
  paramLims = [0.2, 0.02; ...               % lower limits
               0.8, 0.30];                  % upper limits
end
