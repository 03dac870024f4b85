% MEASUREBENCH  Reads the angle of internal friction at steady flow.
%
% CALL: RESULTS = measureBench (FOLDER)
%
% FOLDER   folder of a finished run
% RESULTS  scalar struct: steadyAngle (deg): of the mean shear over the normal stress,
%          mean of three loads; no fields if the run is not sane
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
  load = [checks.load1, checks.load2, checks.load3];
  stress = zeros (1, 3);
  for k = 1:3
    file = fullfile (folder, sprintf ('shear%d.csv', k));
    stress(k) = mean (dlmread (file, ' ', 2, 0)(:, 2));
  end
  results.steadyAngle = mean (atand (stress ./ load));
end
