% BENCHPICTURES  Draws the picture of each bench from a finished run.
%
% CALL: benchPictures (WORK)
%
% WORK  text, folder with the runs of effectSigns; the first null run of each
%       bench is drawn into DEMmodels/<bench>/picture.svg
%
% See also: benchPicture, effectSigns
function benchPictures (work)
  root = startBenchmarks ();
  run = @(bench) fullfile (work, [bench, '--0-10007']);
  out = @(bench) fullfile (root, 'DEMmodels', bench, 'picture.svg');
  last = @(bench, file) readDump (fullfile (run (bench), file)){end};

  ground = [0, 0, 0.15, 0];
  gate = [0, 0, 0, 0.08; 0.04, 0, 0.04, 0.08; 0, 0, 0.05, 0];
  benchPicture (out ('Collapse'), ...
                {last('Collapse', 'column.dump'), ...
                 last('Collapse', 'deposit.dump')}, ...
                {gate, [ground; 0, 0, 0, 0.08]});

  a = (0:60).' / 60 * 2 * pi;
  ring = 0.04 * [cos(a), sin(a)];
  ring = [ring(1:end - 1, :), ring(2:end, :)];
  benchPicture (out ('Drum'), ...
                {last('Drum', 'surface1.dump'), ...
                 last('Drum', 'surface2.dump'), ...
                 last('Drum', 'surface3.dump')}, {ring, ring, ring});

  plate = [-0.032, 0, 0.032, 0];
  benchPicture (out ('Heap'), {last('Heap', 'heap.dump')}, {plate});

  bins = [-0.07, 0, -0.07, 0.06; 0, 0, 0, 0.06; 0.07, 0, 0.07, 0.06; ...
          -0.07, 0, -0.02, 0; 0.03, 0, 0.07, 0];
  benchPicture (out ('SlotBin'), {last('SlotBin', 'rest.dump')}, {bins});

  floor1 = [0, 0, 0.032, 0];
  benchPicture (out ('Shear'), {last('Shear', 'bed.dump')}, {floor1});
end
