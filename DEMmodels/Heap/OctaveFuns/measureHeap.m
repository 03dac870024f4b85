% MEASUREHEAP  Reads slope, height, mass and offset of the heap on the plate.
%
% CALL: RESULTS = measureHeap (FOLDER)
%
% FOLDER   folder of a finished run
% RESULTS  1 x 4: slope (deg), height of the apex (m), mass on the plate (kg),
%          offset of the centre along x (m), see results.csv; all NaN if the
%          run is not sane
%
% The surface is averaged over circles; slope and apex come from a straight
% line between 0.2 and 0.8 of the plate's radius.
%
% Throws what readChecks and readDump throw for a missing file.
%
% See also: readDump, surfaceAt, readChecks
function results = measureHeap (folder)
  results = NaN (1, 4);
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
  results(1) = atand (-line(1));
  results(2) = line(2);
  results(3) = checks.massStart * share;
  results(4) = mean (grains(:, 1));
end
