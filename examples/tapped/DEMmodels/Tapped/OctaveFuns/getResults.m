% GETRESULTS  Hausner ratio of a run of Tapped: of two models, as it starts from Loose.
function res = getResults (model, folderName)
  %| pragma Justify (metric, "globals", "published way in");
  global path
  folder = [path, 'optim/', model, '/', folderName];
  loose = readResults ([folder, '/Loose/output_density'], {'bulkDensity'});
  tapped = readResults ([folder, '/output_density'], {'bulkDensity'});
  res = {tapped / loose};
end
