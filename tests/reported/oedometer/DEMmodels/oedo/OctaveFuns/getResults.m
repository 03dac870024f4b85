function res = getResults (model, folderName)
  %| pragma Justify (metric, "globals", "published getResults read it");
  global path
  file = [path, 'optim/', model, '/', folderName, '/curve.txt'];
  res.p = [NaN, NaN];
  if exist (file, 'file')
    res.p = load (file);
  end
end
