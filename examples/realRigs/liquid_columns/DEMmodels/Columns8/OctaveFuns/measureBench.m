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
  radius = median (beads(:, 4));
  sector = ceil ((atan2 (beads(:, 2), beads(:, 1)) / pi + 1) * 12);
  reach = accumarray (max (sector, 1), r, [24, 1], ...
                      @(own) lastBefore (own, 6 * radius), 0);
  front = mean (max (reach + radius, least));
end

function last = lastBefore (own, gap)
  own = sort (own);
  last = own(min ([find(diff (own) > gap, 1), numel(own)]));
end

%!test
%! % a ring of beads inside the cylinder, then one at 0.1 m with rings behind it
%! % and a lone bead far out; what comes back in is not seen
%! folder = tempname ();
%! mkdir (folder);
%! checks = {'spheresStart,96', 'spheresOut,0', 'spheresEnd,96', 'settled,1', ...
%!           'overlapMax,0.01', 'timeStep,0.001', 'wallRadius,0.0615', ...
%!           'stepLift,100'};
%! writeAtomic (fullfile (folder, 'output_checks.csv'), ...
%!              sprintf ("%s\n", checks{:}));
%! a = (0:23)' * pi / 12 + 0.1;
%! rings = @(R) [kron(R, cos (a)), kron(R, sin (a))];
%! text = '';
%! for k = 1:3
%!   P = rings ([0.01; 0.03; 0.05; 0.05]);
%!   if k == 2
%!     P = rings ([0.07; 0.08; 0.09; 0.096]);
%!     P(1, :) = [0.3, 0.04];
%!   end
%!   text = [text, sprintf(['ITEM: TIMESTEP\n%d\nITEM: NUMBER OF ATOMS\n96\n', ...
%!                          'ITEM: BOX BOUNDS ff ff ff\n-1 1\n-1 1\n0 1\n', ...
%!                          'ITEM: ATOMS id x y z radius \n'], 50 * k + 50), ...
%!           sprintf("1 %g %g 0.004 0.004\n", P')];
%! end
%! writeAtomic (fullfile (folder, 'front.dump'), text);
%! front = measureBench (folder).timeFront;
%! delete (fullfile (folder, '*'));
%! rmdir (folder);
%! assert (front, [0, 0.0615; 0, 0.0615; 0.05, 0.1; 0.1, 0.1], 1e-6);
