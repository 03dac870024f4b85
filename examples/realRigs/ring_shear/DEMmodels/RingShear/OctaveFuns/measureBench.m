% MEASUREBENCH  Reads the shear stress at each load.
%
% CALL: RESULTS = measureBench (FOLDER)
%
% FOLDER   folder of a finished run
% RESULTS  scalar struct: stress (3 x 2: normal stress, mean shear stress; Pa); no
%          fields if the run is not sane
%
% Throws what readChecks throws for a missing file.
%
% See also: readChecks
function results = measureBench (folder)
  results = struct ();
  checks = readChecks (folder);
  if ~checks.sane
    return
  end
  results.stress = [checks.load1, 0; checks.load2, 0; checks.load3, 0];
  for k = 1:3
    file = fullfile (folder, sprintf ('shear%d.csv', k));
    results.stress(k, 2) = mean (dlmread (file, ' ', 2, 0)(:, 2));
  end
end
