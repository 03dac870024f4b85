% GETRESULTS  Results of a run of the bench Collapse.
%
% CALL: RES = getResults (MODEL, FOLDERNAME)
%
% MODEL       name of the model's folder below optim/
% FOLDERNAME  name of the run's folder
% RES         cell of scalars, in the order of results.csv; NaN where a file is
%             missing or the run is not sane
%
% See also: measureBench, benchResults

function res = getResults (model, folderName)
  res = benchResults (@measureBench, model, folderName);
end
