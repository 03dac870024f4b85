function [Input, optim, modelVars, assign, paramLims] = loadInput ()
  Input.model = {'M'};
  Input.cpu = 1;
  Input.maxCPU = 1;
  Input.numOfSam = 8;
  optim.tolfun = 0.002;
  modelVars = struct ();
  assign = {'E', 'mu'};
  paramLims = [1e5, 0.1; 1e9, 0.9];
  optim.targetVal{1} = [54, 29.27];
  optim.tolRes{1} = [0.02, 0.03];
end
