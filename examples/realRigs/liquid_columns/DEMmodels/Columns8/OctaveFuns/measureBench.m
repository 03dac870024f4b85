% MEASUREBENCH  Reads how far the beads of a lifted column have come.
%
% CALL: RESULTS = measureBench (FOLDER)
%
% FOLDER   folder of a finished run
% RESULTS  scalar struct: timeFront (n x 2: time since the lift began, s; front of
%          the beads, m); no fields if the run is not sane
%
% The front is what the cameras give, a mean over the azimuth: in each of 24
% sectors the outside of the outermost bead that hangs together with those behind
% it (no gap of two diameters). Before it leaves the cylinder, the outside of that is
% seen. A front does not go back.
%
% Throws what readChecks and readDump throw for a missing file.
%
% See also: readDump, readChecks
function results = measureBench (folder)
  results = struct ();
  checks = readChecks (folder);
  if ~checks.sane
    return
  end
  [frames, steps] = readDump (fullfile (folder, 'front.dump'));
  use = steps >= checks.stepLift;
  time = (steps(use) - checks.stepLift) * checks.timeStep;
  front = cellfun (@(beads) frontOf (beads, checks.wallRadius), frames(use));
  results.timeFront = [0, checks.wallRadius; time(:), cummax(front(:))];
end

function front = frontOf (beads, least)
  r = hypot (beads(:, 1), beads(:, 2));
  sector = ceil ((atan2 (beads(:, 2), beads(:, 1)) / pi + 1) * 12);
  reach = accumarray (max (sector, 1), r, [24, 1], @lastBefore, 0);
  front = mean (max (reach + median (beads(:, 4)), least));

  function last = lastBefore (own)
    own = sort (own);
    gap = find (diff (own) > 6 * median (beads(:, 4)), 1);
    last = own(min ([gap, numel(own)]));
  end
end
