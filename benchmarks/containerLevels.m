% CONTAINERLEVELS  The container at full size, searched on larger grains.
%
% CALL: octave-cli benchmarks/containerLevels.m WORK REPETITIONS [CPUS]
%
% WORK         folder for the cases and their runs; what is there is not run
%              again
% REPETITIONS  e.g. 1:3
% CPUS         that the runs may use (2)
%
% The benchmark mwe at full size, this tool's side, with Input.coarse levels of
% scaleP 1.6, 1.25 and 1 (the full size): how many core-minutes of DEM (user
% time) until the mean of 5 packings that the calibration has not seen is within
% 1 % in both results? The runs that confirm count as well. Where a set is not
% confirmed, all finished runs are given back as runs.csv and the calibration
% goes on from them with another seed, four times at most. One row a start in
% results/containerLevels.csv: how many runs at each level it made, its
% core-minutes, the residuals of the mean of the 5 packings with the standard
% error of that mean, confirmed.
%
% See also: mwe, mweCase, drumLevels

1;

function measure (work, repetitions, cpus)
  addpath (fileparts (mfilename ('fullpath')));
  root = startBenchmarks ();
  table = zeros (0, 11);
  for r = repetitions
    for start = 1:4
      row = oneStart (root, work, r, start, cpus);
      table(end + 1, :) = row;
      printf ('%d.%d: runs %d %d %d, %.1f min, off by %.4f %.4f (%d)\n', ...
              row([1:6, 7:8, 11]));
      writeMatrix (fullfile (work, 'containerLevels.csv'), table, ...
                   {'repetition', 'start', 'runs160', 'runs125', 'runs100', ...
                    'coreMinutes', 'residualDensity', 'residualMass', ...
                    'seDensity', 'seMass', 'confirmed'});
      if row(end)
        break
      end
    end
  end
end

function row = oneStart (root, work, r, start, cpus)
  setting = struct ('root', root, 'work', work, 'scale', 'full', ...
                    'cpus', cpus);
  seed = 100 * r + start;
  folder = fullfile (work, sprintf ('levels-%d', seed));
  result = fullfile (folder, 'results', 'calibration.json');
  if ~isfile (result)
    mweCase (folder, 'levels', setting, seed);
    giveBack (root, work, r, start, folder);
    system (sprintf ('cd "%s" && octave-cli "%s" > log 2>&1', folder, ...
                     fullfile (root, 'DEcalioc.m')));
  end
  c = jsondecode (fileread (result));
  Case = loaded (root, folder);
  params = cellfun (@(name) c.params.(name), Case.names);
  Z = evaluateDEM (repmat (params, 5, 1), Case, 101:105, 'verify');
  off = Z ./ [Case.targets.value] - 1;
  [runs, minutes] = spentIn (folder);
  row = [r, start, runs, minutes, mean(off, 1), std(off, 0, 1) / sqrt(5), ...
         all(abs (mean (off, 1)) <= 0.01)];
end

function Case = loaded (root, folder)
  cd (folder);                % the folder one is in goes before the path
  startToolbox (root, folder);
  useLiggghts (root);
  Case = loadCase (root, folder);
end

% What the starts before have run, as a user would hand it over.
function giveBack (root, work, r, start, folder)
  if start == 1
    return
  end
  before = loaded (root, fullfile (work, sprintf ('levels-%d', ...
                                                  100 * r + start - 1)));
  exportRuns (fullfile (folder, 'runs.csv'), before, gatherRuns (before));
end

function [runs, minutes] = spentIn (folder)
  names = listRunFolders (folder, 'Lift100');
  known = [1.6, 1.25, 1];
  runs = zeros (1, 3);
  minutes = 0;
  for k = 1:numel (names)
    place = fullfile (folder, 'optim', 'Lift100', names{k});
    level = headDefaults (fullfile (place, 'data.head')).scaleP;
    runs = runs + (level == known);
    minutes = minutes + ...
              str2double (fileread (fullfile (place, 'cpu.txt'))) / 60;
  end
end

given = argv ();
span = sscanf (given{2}, '%d:%d')';
cpus = 2;
if numel (given) > 2
  cpus = str2double (given{3});
end
measure (make_absolute_filename (given{1}), span(1):span(end), cpus);
