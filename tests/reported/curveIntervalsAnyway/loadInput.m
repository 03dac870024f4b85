function [Input, optim, modelVars, assign, paramLims] = loadInput ()
  Input.model = {'Neck'};
  Input.cpu = 1;
  Input.maxCPU = 1;
  Input.numOfSam = 10;
  Input.maxNewRuns = 0;
  optim.tolRes = 0.05;
  modelVars = struct ();
  assign = {'rate', 'size'};
  paramLims = [0.1, 1e-6; 100, 1];
end
