function [Input, optim, modelVars, assign, paramLims] = loadInput ()

  Input.model = {'M'};
  Input.cpu = ones (1, 1);
  Input.maxCPU = 1;
  Input.numOfSam = 8;
  optim.tolfun = 0.002;
  modelVars = struct ();
  assign = {'a', 'b'};
  paramLims = [0.0 0.0; 1.0 2.0];
  optim.targetVal{1} = [4, 1.9, 1.5];
  optim.tolRes{1} = [0.02 0.02 0.02];

end
