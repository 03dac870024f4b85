% GETRESULTS  Results of a run of the bench Drum.
%
% CALL: RES = getResults (MODEL, FOLDERNAME)
%
% MODEL       name of the model's folder below optim/
% FOLDERNAME  name of the run's folder
% RES         1 x 9 cell of scalars, in the order of results.csv; NaN where a
%             file is missing or the run is not sane
%
% Finds the files from the global variable path, as all DEcalioc models do.
%
% See also: measureDrum
function res = getResults (model, folderName)
  %| pragma Justify (metric, "globals", "published way in");
  global path
  try
    folder = [path, 'optim/', model, '/', folderName, '/'];
    res = num2cell (measureDrum (folder));
  catch
    res = num2cell (NaN (1, 9));
  end
end
