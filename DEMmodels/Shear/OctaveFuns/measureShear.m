% MEASURESHEAR  Reads the yield line and the density of the sheared bed.
%
% CALL: RESULTS = measureShear (FOLDER)
%
% FOLDER   folder of a finished run
% RESULTS  1 x 4: intercept (Pa) and slope (-) of shear stress over load,
%          density of the bed (kg/m3) at the lowest and the highest load, see
%          results.csv; all NaN if the run is not sane
%
% Three loads, a straight line through their mean stresses by least squares.
%
% Throws what readChecks throws for a missing file.
%
% See also: readChecks
function results = measureShear (folder)
  results = NaN (1, 4);
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
  results = [line(2), line(1), density(1), density(3)];
end
