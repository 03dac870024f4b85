% GETRESULTS  Bulk density as poured (kg/m3), of a run of Loose.
function res = getResults (model, folderName)
  %| pragma Justify (metric, "globals", "published way in");
  global path
  file = [path, 'optim/', model, '/', folderName, '/output_density'];
  res = num2cell (readResults (file, {'bulkDensity'}));
end
