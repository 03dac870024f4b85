% GETRESULTS  Reads the two results of a run of the model Slump.
%
% CALL: RES = getResults (MODEL, FOLDERNAME)
%
%   RES  1 x 2 cell: centre of mass, distance from the wall and height (m);
%        NaN where the file is missing

function res = getResults (model, folderName)
  %| pragma Justify (metric, "globals", "the published call of getResults");
  global path
  file = [path, 'optim/', model, '/', folderName, '/output_centre'];
  res = {NaN, NaN};
  if exist (file, 'file')
    res = num2cell (load (file));
  end
end
