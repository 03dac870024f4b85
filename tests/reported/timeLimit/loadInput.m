function [Input, optim, modelVars, assign, paramLims] = loadInput ()

  Input.model = {'M'};
  Input.cpu = ones (1, 1);
  Input.maxCPU = 4;
  Input.numOfSam = 8;
  optim.tolfun = 0.002;
  modelVars = struct ();
  assign = {'a', 'b'};
  paramLims = [0.0 0.0; 1.0 2.0];
  optim.targetVal{1} = [4.35, 2.25, 1.85];
  optim.tolRes{1} = [0.02 0.02 0.02];

end
