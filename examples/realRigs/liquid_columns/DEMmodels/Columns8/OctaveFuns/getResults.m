% GETRESULTS  Results of a run of the bench of lifted columns.
%
% CALL: RES = getResults (MODEL, FOLDERNAME)
%
% MODEL       name of the model's folder below optim/
% FOLDERNAME  name of the run's folder
% RES         cell of scalars, in the order of results.csv; NaN where a file is
%             missing or the run is not sane
%
% See also: measureBench, namedResults

function res = getResults (model, folderName)
  %| pragma Justify (metric, "globals", "published way in");
  global path
  here = fileparts (fileparts (mfilename ('fullpath')));
  res = namedResults (@measureBench, ...
                      [path, 'optim/', model, '/', folderName, '/'], here);
end
