% GETRESULTS  Bulk density (kg/m3), reach and height (m) of a run in LAMMPS.
function res = getResults (model, folderName)
  %| pragma Justify (metric, "globals", "published way in");
  global path
  file = [path, 'optim/', model, '/', folderName, '/output_results'];
  res = num2cell (readResults (file, {'bulkDensity', 'reach', 'height'}));
end
