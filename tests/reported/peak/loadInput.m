function [Input, optim, modelVars, assign, paramLims] = loadInput ()

  Input.model = {'M'};
  Input.cpu = ones (1, 1);
  Input.maxCPU = 1;
  Input.numOfSam = 8;
  optim.tolfun = 0.002;
  modelVars = struct ();
  assign = {'a', 'b'};
  paramLims = [0.0 0.0; 1.0 1.0];
  optim.targetVal{1} = [8 3.3];
  optim.tolRes{1} = [0.05 0.03];

end
