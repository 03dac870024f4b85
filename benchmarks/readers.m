% READERS  Bias and scatter of the readers of angles, on drawn shapes and on runs.
%
% CALL: octave-cli benchmarks/readers.m N WORK
%
%   N     drawn shapes of each kind, and packings of each bench (at most 8), e.g. 40
%   WORK  folder for the runs; finished ones are taken as they are
%
% Drawn: grains between the base and a straight surface, of known angle (20 to 40
% deg) and base radius, seen as a picture (noise, uneven light, a camera rolled by up
% to 2 deg) and as a frame. Runs: of the benches Heap, Drum and SlotBin, each reading
% against what the rig is known to be (radius of the plate, the angle that the bench
% reads by its own rule) and the picture against the frame of the same run. A line a
% comparison: mean difference (bias) with its standard error, scatter of the
% differences, and the stated uncertainty (root mean square).
%
% See also: flankAngles, drawDownFaces, overFrames, photoOf

1;

function grains = drawnGrains (surface, width, r)
  n = 8000;
  x = width * (2 * rand (n, 1) - 1);
  z = surface (x) .* rand (n, 1).^(0.5 + 0.5 * (rand (n, 1) < 0.5));   % no holes
  keep = z > 0.5 * r;
  grains = [x(keep), 0.02 * rand(sum (keep), 1), z(keep), repmat(r, sum (keep), 1)];
end

function heap = photoHeap (grains, how)
  file = [tempname(), '.png'];
  scale = (max (grains(:, 1)) - min (grains(:, 1))) / 700;
  photoOf (file, grains, scale, how);
  [x, z] = pictureOutline (file);
  unlink (file);
  heap = flankAngles (x * scale, z * scale);
end

function heap = frameHeap (grains)
  w = max (abs (grains(:, 1))) + 2 * max (grains(:, 4));
  x = linspace (-w, w, 600);
  heap = flankAngles (x, silhouette (grains, x));
end

function sayRow (what, unit, differences, stated)
  d = differences(isfinite (differences));
  s = sqrt (mean (stated(isfinite (stated)).^2));
  printf ('| %s (%s) | %d | %+.3g +- %.2g | %.2g | %.2g |\n', what, unit, numel (d), ...
          mean (d), std (d) / sqrt (numel (d)), std (d), s);
end

function drawnHeaps (n)
  [photo, frame, radius] = deal (NaN (n, 2));
  for k = 1:n
    angle = 20 + 20 * rand ();
    r = 0.001;
    base = 0.05;
    grains = drawnGrains (@(x) max (0, (base - abs (x)) * tand (angle) - r), base, r);
    how = struct ('roll', 4 * rand () - 2, 'noise', 8, 'light', 40);
    p = photoHeap (grains, how);
    f = frameHeap (grains);
    photo(k, :) = [p.angle - angle, p.sd];
    frame(k, :) = [f.angle - angle, f.sd];
    radius(k, :) = [1e3 * (p.radius - base), 1e3 * p.radiusSd];
  end
  sayRow ('drawn heap, picture less known angle', 'deg', photo(:, 1), photo(:, 2));
  sayRow ('drawn heap, frame less known angle', 'deg', frame(:, 1), frame(:, 2));
  sayRow ('drawn heap, picture less known radius of 50', 'mm', radius(:, 1), radius(:, 2));
end

function drawnFaces (n)
  found = NaN (n, 2);
  for k = 1:n
    angle = 20 + 20 * rand ();
    r = 0.001;
    surface = @(x) min (0.02, max (0, (abs (x) - 0.005) * tand (angle))) - r;
    grains = drawnGrains (surface, 0.08, r);
    x = linspace (-0.08, 0.08, 700);
    faces = drawDownFaces (x, silhouette (grains, x));
    found(k, :) = [faces.angle - angle, faces.sd];
  end
  sayRow ('drawn draw-down faces, frame less known angle', 'deg', found(:, 1), found(:, 2));
end

function onRuns (n, work)
  n = min (n, 8);
  [heap, folders] = benchRuns (fullfile (work, 'Heap--0'), 'Heap', struct (), n);
  [own, photo, radius] = deal (NaN (n, 2));
  for k = 1:n
    grains = readDump (fullfile (folders{k}, 'heap.dump')){end};
    grains = grains(grains(:, 3) > 0, :);
    f = frameHeap (grains);
    p = photoHeap (grains, struct ('noise', 8, 'light', 40));
    plate = readChecks (folders{k}).plateRadius;
    own(k, :) = [f.angle - heap(k, 1), f.sd];
    photo(k, :) = [p.angle - f.angle, p.sd];
    radius(k, :) = 1e3 * [f.radius - plate, f.radiusSd];
  end
  sayRow ('Heap, frame less the bench''s own slope', 'deg', own(:, 1), own(:, 2));
  sayRow ('Heap, picture less frame of the same run', 'deg', photo(:, 1), photo(:, 2));
  sayRow ('Heap, foot of the flanks less radius of the plate', 'mm', radius(:, 1), ...
          radius(:, 2));
  [drum, folders] = benchRuns (fullfile (work, 'Drum--0'), 'Drum', struct (), n);
  found = NaN (n, 2);
  for k = 1:n
    R = readChecks (folders{k}).drumRadius;
    frames = readDump (fullfile (folders{k}, 'surface1.dump'));
    [angle, sd] = overFrames (frames, @(g) surfaceLine (g, -0.6 * R, 0.6 * R));
    found(k, :) = [abs(angle) - drum(k, 1), sd];
  end
  sayRow ('Drum, line over frames less the bench''s own slope', 'deg', found(:, 1), ...
          found(:, 2));
  [bin, folders] = benchRuns (fullfile (work, 'SlotBin--0'), 'SlotBin', struct (), n);
  columns_ = [3, 6];
  found = NaN (n, 2);
  for k = 1:n
    grains = readDump (fullfile (folders{k}, 'rest.dump')){end};
    w = readChecks (folders{k}).binLength;
    x = linspace (-w, w, 700);
    faces = drawDownFaces (x, silhouette (grains, x));
    found(k, :) = [faces.angle - mean(bin(k, columns_)), faces.sd];
  end
  sayRow ('SlotBin, faces less the bench''s own slopes', 'deg', found(:, 1), found(:, 2));
end

addpath (fileparts (mfilename ('fullpath')));
startBenchmarks ();
words = argv ();
n = str2double (words{end - 1});
rand ('twister', 7);
randn ('twister', 7);
printf ('| comparison | n | bias +- standard error | scatter | stated |\n');
printf ('|---|---|---|---|---|\n');
drawnHeaps (n);
drawnFaces (n);
onRuns (n, make_absolute_filename (words{end}));
