% Readers on runs of LIGGGHTS: each against what is known of the run's own geometry,
% and the picture of a run against the run by the same rule.

%!function [folder, results] = runOf (bench)
%!  root = fileparts (fileparts (which ('startProgram')));
%!  addpath (fullfile (root, 'benchmarks', 'benches'));
%!  useLiggghts (root);
%!  folder = tempname ();
%!  results = benchRun (folder, bench, struct ());
%!  assert (all (isfinite (results)));
%!endfunction

%!test
%! % a heap on a round plate: the flanks' foot lies at its rim, their angle is that of
%! % the bench, which averages over circles; the picture says the same as the run
%! [folder, results] = runOf ('Heap');
%! grains = readDump (fullfile (folder, 'heap.dump')){end};
%! grains = grains(grains(:, 3) > 0, :);
%! plate = readChecks (folder).plateRadius;
%! d = 2 * median (grains(:, 4));
%! x = linspace (-1.2, 1.2, 600) * plate;
%! run = flankAngles (x, silhouette (grains, x));
%! assert (abs (run.radius - plate - d / 2) < d);   % grains at the rim overhang it
%! assert (run.angle, results(1), 4);
%! assert (run.sd > 0 && run.sd < 5);
%! file = fullfile (folder, 'photo.png');
%! scale = 2.4 * plate / 700;
%! photoOf (file, grains, scale, struct ('noise', 8, 'light', 40));
%! [u, v] = pictureOutline (file);
%! photo = flankAngles (u * scale, v * scale);
%! assert (photo.angle, run.angle, 1.5);
%! assert (abs (photo.radius - run.radius) < d);
%! [status, out] = startCommand (folder, sprintf ('measure photo.png --scale %.6g', ...
%!                                                1e3 * scale));
%! assert (status == 0, out);
%! rows = regexp (out, ',(\w+),([\d.]+),', 'tokens');
%! assert ({rows{1}{1}, rows{2}{1}}, {'angle', 'radius'});
%! assert (str2double (rows{1}{2}), photo.angle, 0.01);
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (folder, 's');

%!test
%! % two bins that have run out towards the middle: two faces, and slopes by stretch
%! [folder, results] = runOf ('SlotBin');
%! grains = readDump (fullfile (folder, 'rest.dump')){end};
%! w = readChecks (folder).binLength;
%! x = linspace (-w, w, 700);
%! z = silhouette (grains, x);
%! faces = drawDownFaces (x, z);
%! assert ([faces.left, faces.right], results([3, 6]), 4);
%! assert (faces.width > 0 && faces.width < 2 * w);
%! assert (faces.sd > 0 && faces.sd < 4);
%! angles = slopeByBins (x, z, [-0.8, -0.3, 0.3, 0.8] * w);
%! assert (angles(1) < -10 && angles(3) > 10);
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (folder, 's');

% SPDX-License-Identifier: GPL-3.0-only
