% GETRESULTS  Results of a run of the bench CentralSlot.
%
% CALL: RES = getResults (MODEL, FOLDERNAME)
%
% MODEL       name of the model's folder below optim/
% FOLDERNAME  name of the run's folder
% RES         scalar struct: timeDischarge (n x 2: time since the slot opened
%             in s, share of the filled mass that has left in %, held at its
%             last value once the grains rest) and remaining (%); NaN where a
%             file is missing or the run is not sane
%
% Finds the files from the global variable path, as all DEcalioc models do.
%
% See also: readChecks
function res = getResults (model, folderName)
  %| pragma Justify (metric, "globals", "published way in");
  global path
  res = struct ('timeDischarge', NaN, 'remaining', NaN);
  try
    folder = [path, 'optim/', model, '/', folderName, '/'];
    checks = readChecks (folder);
    if checks.sane
      flow = dlmread (fullfile (folder, 'flow.csv'), ',', 1, 0);
      gone = 100 * (1 - flow(:, 2) / flow(1, 2));
      res.timeDischarge = [flow(:, 1), gone; 1e3, gone(end)];
      res.remaining = 100 - gone(end);
    end
  catch
    res = struct ('timeDischarge', NaN, 'remaining', NaN);
  end
end
