function res = getResults (model, folderName)
  %| pragma Justify (metric, "globals", "published getResults read it");
  global path
  file = [path, 'optim/', model, '/', folderName, '/out'];
  res = repmat ({NaN}, 1, 2);
  if exist (file, 'file')
    x = load (file)';
    res(1:numel (x)) = num2cell (x);
  end
end
