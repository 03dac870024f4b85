% MEASUREBENCH  Reads how much a screw doses in a turn, at tilts and speeds.
%
% CALL: RESULTS = measureBench (FOLDER)
%
% FOLDER   folder of a finished run
% RESULTS  scalar struct, a field per result of results.csv; no fields if the
%          run is not sane
%
% Logarithms of mean masses of a turn, each with half a grain more than what has left, so that a
% blocked exit is a number. One filling of a pitch has 0.6 of its volume as solid.
% A grain between the turning screw and the cone may overlap by half its
% diameter, the bed at rest by what readChecks allows.
%
% Throws what readChecks throws for a missing file.
%
% See also: readChecks
function results = measureBench (folder)
  results = struct ();
  checks = readChecks (folder);
  if ~checks.sane || checks.overlapTurn > 0.5
    return
  end
  table = dlmread (fullfile (folder, 'dosed.csv'), ',', 1, 0);
  isRead = table(:, 5) == 1;
  mean_ = accumarray (table(isRead, 1) + 1, table(isRead, 6), [], @mean);
  dosed = log (mean_ + 0.5 * checks.massGrain);
  middle = dosed(2);
  results.level = middle - log (0.6 * checks.pitchVolume * checks.densityGrain);
  names = {'tilt0', 'level', 'speed15', 'speed45', 'speed90', 'tilt90'};
  for stage = unique (table(isRead, 1))'
    if stage ~= 1
      results.(names{stage + 1}) = dosed(stage + 1) - middle;
    end
  end
end
