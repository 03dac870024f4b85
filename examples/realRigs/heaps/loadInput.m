% LOADINPUT  Heaps poured by hand: a reference and another series, three sets.
%
% CALL: [Input, optim, modelVars, assign, paramLims] = loadInput ()
%
% Rig and grains are not told, so the bench Heap stands for them: only angles are
% compared. Its runs are those of examples/hiddenEffect (runs.csv), with whatever these
% have of effects; none is added. One form for the sets A, B and C (a folder each, with
% its measured.csv).
%
% See also: loadEffects, diagnoseGap

function [Input, optim, modelVars, assign, paramLims] = loadInput ()
  Input.model = {'Heap'};
  Input.cpu = 1;
  Input.maxCPU = 1;
  Input.numOfSam = 20;
  Input.seed = 1;
  Input.maxNewRuns = 0;

  optim.maxFunEvals = 1;

  modelVars = struct ();

  assign = {'densityP', 'coefFrictionPP', 'coefFrictionPW', ...
            'coefRollingFrictionPP'};
  paramLims = [1000, 0.2, 0.2, 0.01; ...
               1600, 0.7, 0.7, 0.1];
end
