% MEASUREBENCH  Reads the discharge curve of the bin with a slot in the middle.
%
% CALL: RESULTS = measureBench (FOLDER)
%
% FOLDER   folder of a finished run
% RESULTS  scalar struct: timeDischarge (n x 2: time since the slot opened in s,
%          share of the filled mass that has left in %, held at its last value
%          once the grains rest) and remaining (%); no fields if the run is not
%          sane
%
% Throws what readChecks throws, and where a file is missing.
%
% See also: readChecks
function results = measureBench (folder)
  results = struct ();
  checks = readChecks (folder);
  if ~checks.sane
    return
  end
  flow = dlmread (fullfile (folder, 'flow.csv'), ',', 1, 0);
  gone = 100 * (1 - flow(:, 2) / flow(1, 2));
  results.timeDischarge = [flow(:, 1), gone; 1e3, gone(end)];
  results.remaining = 100 - gone(end);
end
