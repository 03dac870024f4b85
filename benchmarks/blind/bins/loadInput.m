% LOADINPUT  A sealed case: a model without any effect, values in measured.csv.
%
% CALL: [Input, optim, modelVars, assign, paramLims] = loadInput ()
%
% The same parameters as in benchmarks/drumAndBins. measured.csv holds what the
% laboratory hands over, runs.csv the campaign that all sealed cases share.
%
% See also: blind

function [Input, optim, modelVars, assign, paramLims] = loadInput ()
  Input.model = {'Drum', 'SlotBin'};
  Input.cpu = [1, 1];
  Input.maxCPU = 2;
  Input.numOfSam = 45;
  Input.seed = 1;
  Input.maxNewRuns = 0;                 % runs.csv alone
  optim.tolRes = 0.02;
  modelVars = struct ();
  assign = {'densityP', 'coefFrictionPP', 'coefFrictionPW', ...
            'coefRollingFrictionPP'};
  paramLims = [1000, 0.2, 0.2, 0.01; ...
               1600, 0.7, 0.7, 0.1];
end
