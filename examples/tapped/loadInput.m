% LOADINPUT  Two models of which one starts from the state that the other left.
%
% CALL: [Input, optim, modelVars, assign, paramLims] = loadInput ()
%
% The values in measured.csv are simulated: see README.md.
%
% See also: DEcalioc

function [Input, optim, modelVars, assign, paramLims] = loadInput ()
  Input.model = {'Loose', 'Tapped'};
  Input.cpu = [1, 1];
  Input.maxCPU = 2;
  Input.numOfSam = 10;
  optim.maxFunEvals = 16;
  modelVars = struct ();
  assign = {'densityP', 'coefFrictionPP'};
  paramLims = [1500, 0.1; 2800, 0.9];
end
