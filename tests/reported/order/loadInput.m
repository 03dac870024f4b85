function [Input, optim, modelVars, assign, paramLims] = loadInput ()
  Input.model = {'M'};
  Input.cpu = 1;
  Input.maxCPU = 1;
  Input.numOfSam = 9;
  Input.constraints = {'a < b'};
  optim.tolfun = 0.002;
  modelVars = struct ();
  assign = {'a', 'b'};
  paramLims = [0, 0; 1, 1];
  optim.targetVal{1} = [4.9, 3.9];
  optim.tolRes{1} = [0.02, 0.02];
end
