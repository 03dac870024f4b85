% MWEWAITS  What each difference to the published run of the container saves.
%
% CALL: mweWaits (WORK, NSEEDS)
%
% WORK    text, folder of the runs; finished runs in it are reused
% NSEEDS  number of packings, at most 8
%
% The container Lift100 at the values of its data.head, step by step from the
% published run to the toolbox's own:
%   own waits   rain of 2 s, settling of 3 s, discharge of 10 s, waited out,
%               neighbour skin 4 mm, Debian's binary
%   published   the same with 4 s of discharge, as in the benchmark mwe
%   build       the toolbox's build of LIGGGHTS
%   skin        neighbour skin 2 mm
%   criteria    settling and discharge end when the grains are at rest
%   pack        filled by one insertion: the toolbox's own run
%   two ranks   the same on two MPI ranks
% Writes benchmarks/results/mweWaits.csv (setting, seed, user time (s), density,
% mass left) and prints the ratios to the toolbox's own run, mean and 95 %
% interval over the packings. About 13 core-minutes a packing; two ranks need
% two free cores.
%
% See also: mwe, liggghtsBuilds

function mweWaits (work, nSeeds)
  root = startBenchmarks ();
  settings = ladder ();
  seconds = zeros (nSeeds, rows (settings));
  fid = fopen (fullfile (root, 'benchmarks', 'results', 'mweWaits.csv'), 'w');
  fprintf (fid, "setting,seed,seconds,density,mass\n");
  % packings outside: a machine that gets busier then slows all settings alike
  for s = 1:nSeeds
    for i = 1:rows (settings)
      row = timedRun (work, root, settings(i, :), benchSeeds (s));
      fprintf (fid, "%s,%d,%.2f,%.6g,%.6g\n", settings{i, 1}, ...
               benchSeeds (s), row);
      fflush (fid);
      seconds(s, i) = row(1);
    end
  end
  fclose (fid);
  sayRatios (settings(:, 1), seconds, 'pack');
end

% n x 4: name, variables, program, preparation of the run's folder
function settings = ladder ()
  debian = '/usr/bin/liggghts';
  published = struct ('fillMethod', 1, 'useCriteria', 0, 'skin', 4e-3);
  thin = setfield (published, 'skin', 2e-3);
  ranks = ['export DECALIOC_CPU=2 OMPI_ALLOW_RUN_AS_ROOT=1 ', ...
           'OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 ', ...
           'OMPI_MCA_hwloc_base_binding_policy=none'];
  settings = {'own waits', setfield(published, 'dischargeTime', 10), ...
              debian, 'true'; ...
              'published', published, debian, 'true'; ...
              'build', published, '', 'true'; ...
              'skin', thin, '', 'true'; ...
              'criteria', setfield(thin, 'useCriteria', 1), '', 'true'; ...
              'pack', struct(), '', 'true'; ...
              'two ranks', struct(), '', ranks};
end

function row = timedRun (work, root, setting, seed)
  folder = fullfile (work, sprintf ('%s-%d', strrep (setting{1}, ' ', '-'), ...
                                    seed));
  [~, path] = system (sprintf ('LIGGGHTS=%s bash "%s"', setting{3}, ...
                               fullfile (root, 'tools', 'liggghts', ...
                                         'path.sh')));
  [~, seconds] = benchRun (folder, 'Lift100', ...
                           setfield (setting{2}, 'runSeed', seed), ...
                           sprintf ('export PATH="%s:$PATH" && %s', ...
                                    strtrim (path), setting{4}));
  number = @(file) str2double (fileread (fullfile (folder, file)));
  row = [seconds, number('output_density'), number('output_mass')];
end
