% MEASUREBENCH  Reads the yield line and the density of the sheared bed.
%
% CALL: RESULTS = measureBench (FOLDER)
%
% FOLDER   folder of a finished run
% RESULTS  scalar struct, a field per result of results.csv; no fields if the
%          run is not sane
%
% Three loads, a straight line through their mean stresses by least squares.
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
  density = zeros (1, 3);
  for k = 1:3
    file = fullfile (folder, sprintf ('shear%d.csv', k));
    rows = dlmread (file, ' ', 2, 0);
    stress(k) = mean (rows(:, 2));
    density(k) = mean (rows(:, 3));
  end
  line = polyfit (load, stress, 1);
  results = struct ('intercept', line(2), 'friction', line(1), ...
                    'densityLow', density(1), 'densityHigh', density(3));
end
