% LOADINPUT  Heaps poured by hand: a reference and another series, three sets.
%
% CALL: [Input, optim, modelVars, assign, paramLims] = loadInput ()
%
% Rig and grains are not told, so the bench Heap stands for them: only angles are
% compared. One form for the sets A, B and C (a folder each, with its measured.csv);
% they share their runs.
%
% See also: loadEffects, diagnoseGap

function [Input, optim, modelVars, assign, paramLims] = loadInput ()
  Input.model = {'Heap'};
  Input.cpu = 1;
  Input.maxCPU = 1;
  Input.numOfSam = 10;
  Input.seed = 1;
  Input.timeout = 600;
  Input.maxNewRuns = 14;
  Input.store = '../runs';

  optim.maxFunEvals = 1;

  modelVars = struct ();

  assign = {'coefFrictionPP', 'coefRollingFrictionPP'};
  paramLims = [0.10, 0.005; ...
               0.70, 0.300];
end
