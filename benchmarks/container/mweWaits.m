% MWEWAITS  What waits and program of the published tool cost in one run.
%
% CALL: mweWaits (WORK, NSEEDS)
%
% WORK    text, folder of the runs; finished runs in it are reused
% NSEEDS  number of packings
%
% The container Lift100 at the values of its data.head, one run a packing:
%   ours       pack, ends of settling by criterion, discharge 4 s, own build
%   published  rain, fixed waits, discharge 4 s, skin 4 mm, Debian's binary
%   own waits  the same with the published wait of 10 s for the discharge
%   own build  published, with the build of this toolbox
%   skin       own build, with a neighbour skin of 2 mm
% Writes benchmarks/results/mweWaits.csv (setting, seed, seconds of user time,
% density, mass after 4 s or at the end).
%
% See also: mwe
function mweWaits (work, nSeeds)
  root = startBenchmarks ();
  rain = struct ('fillMethod', 1, 'useCriteria', 0, 'skin', 4e-3);
  long = setfield (rain, 'dischargeTime', 10);
  thin = setfield (rain, 'skin', 2e-3);
  settings = {'ours', struct(), ''; ...
              'published', rain, '/usr/bin/liggghts'; ...
              'own waits', long, '/usr/bin/liggghts'; ...
              'own build', rain, ''; ...
              'skin', thin, ''};
  fid = fopen (fullfile (root, 'benchmarks', 'results', 'mweWaits.csv'), 'w');
  fprintf (fid, "setting,seed,seconds,density,mass\n");
  % packings outside: a machine that gets busier then slows all settings alike
  for seed = benchSeeds (1:nSeeds)
    for i = 1:rows (settings)
      name = sprintf ('%s-%d', strrep (settings{i, 1}, ' ', '-'), seed);
      variables = setfield (settings{i, 2}, 'runSeed', seed);
      row = timedRun (fullfile (work, name), root, variables, settings{i, 3});
      fprintf (fid, "%s,%d,%.2f,%.6g,%.6g\n", settings{i, 1}, seed, row);
      fflush (fid);
    end
  end
  fclose (fid);
end

function row = timedRun (folder, root, variables, program)
  [~, path] = system (sprintf ('LIGGGHTS=%s bash "%s"', program, ...
                               fullfile (root, 'tools', 'liggghts', ...
                                         'path.sh')));
  [~, seconds] = benchRun (folder, 'Lift100', variables, ...
                           sprintf ('export PATH="%s:$PATH"', strtrim (path)));
  number = @(file) str2double (fileread (fullfile (folder, file)));
  row = [seconds, number('output_density'), number('output_mass')];
end
