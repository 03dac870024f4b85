% GOODPUBLISHED  A case as the user document of 2017 shows it, for tests.
%
% CALL: RAW = goodPublished (FOLDER)
%
%   FOLDER  folder to be made (text)
%   RAW     input of checkCase: one model, the published fields alone, targets
%           stacked as one column, radiusP not declared in data.head
%
% See also: goodInput, checkCase

function raw = goodPublished (folder)
  raw = goodInput (folder);
  Input = struct ();
  Input.model{1} = 'Toy';
  Input.cpu(1, 1) = 1;
  Input.maxCPU = 8;
  Input.numOfSam = 21;
  optim = struct ();
  optim.targetVal{1}(1) = 400;
  optim.targetVal{1}(2) = 0.025;
  optim.tolRes{1}(1) = 0.01;
  optim.tolRes{1}(2) = 0.01;
  optim.tolfun = 0.002;
  optim.maxIter = 3;
  optim.maxFunEvals = 40;
  optim.WRL = 0.5;
  optim.targetVal = horzcat (optim.targetVal{:})';
  optim.tolRes = horzcat (optim.tolRes{:})';
  raw.Input = Input;
  raw.optim = optim;
end

% SPDX-License-Identifier: GPL-3.0-only
