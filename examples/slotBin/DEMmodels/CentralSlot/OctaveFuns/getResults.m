% GETRESULTS  Results of a run of the bench CentralSlot.
%
% CALL: RES = getResults (MODEL, FOLDERNAME)
%
% MODEL       name of the model's folder below optim/
% FOLDERNAME  name of the run's folder
% RES         cell in the order of results.csv: a curve (n x 2) and a scalar;
%             NaN where a file is missing or the run is not sane
%
% See also: measureBench, benchResults

function res = getResults (model, folderName)
  res = benchResults (@measureBench, model, folderName);
end
