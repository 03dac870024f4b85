function [Input, optim, modelVars, assign, paramLims] = loadInput ()
  Input.model{1} = 'Pile';
  Input.cpu = 1;
  Input.maxCPU = 1;
  Input.numOfSam = 5;
  Input.maxNewRuns = 0;
  optim.targetVal{1} = [32, 780];
  optim.targetName{1} = {'angle', 'density'};
  optim.tolRes{1} = [0.004, 0.004];
  modelVars = struct ();
  assign = {'a', 'b'};
  paramLims = [0, 0; 1, 1];
end
