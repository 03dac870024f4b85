% LOADINPUT  A collapse in LAMMPS, calibrated on one with known parameters.
%
% CALL: [Input, optim, modelVars, assign, paramLims] = loadInput ()
%
% The values in measured.csv are simulated: see README.md.
%
% See also: DEcalioc

function [Input, optim, modelVars, assign, paramLims] = loadInput ()
  Input.model{1} = 'LammpsCollapse';
  Input.cpu(1) = 1;
  Input.maxCPU = 2;
  Input.numOfSam = 10;
  optim.maxFunEvals = 24;
  modelVars.densityP = 2500;            % kg/m3
  assign = {'coefFrictionPP', 'coefRollingFrictionPP'};
  paramLims = [0.1, 0.02; 0.9, 0.4];
end
