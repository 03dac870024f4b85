% MEASUREBENCH  Reads slope, height, mass and offset of the heap on the plate.
%
% CALL: RESULTS = measureBench (FOLDER)
%
% FOLDER   folder of a finished run
% RESULTS  scalar struct, a field per result of results.csv; no fields if the
%          run is not sane
%
% The surface is averaged over circles; slope and apex come from a straight
% line between 0.2 and 0.8 of the plate's radius.
%
% Throws what readChecks and readDump throw for a missing file.
%
% See also: readDump, surfaceAt, readChecks
function results = measureBench (folder)
  results = struct ();
  checks = readChecks (folder);
  if ~checks.sane
    return
  end
  grains = readDump (fullfile (folder, 'heap.dump')){end};
  grains = grains(grains(:, 3) > 0, :);
  radii = linspace (0.2, 0.8, 13) * checks.plateRadius;
  angles = 2 * pi * (0:35) / 36;
  height = zeros (size (radii));
  for k = 1:numel (radii)
    height(k) = mean (surfaceAt (grains, radii(k) * cos (angles), ...
                                 radii(k) * sin (angles)));
  end
  line = polyfit (radii, height, 1);
  share = rows (grains) / checks.spheresStart;
  results.slope = atand (-line(1));
  results.height = line(2);
  results.massOnPlate = checks.massStart * share;
  results.offset = mean (grains(:, 1));
end
