% LIGGGHTSBUILDS  Speed of LIGGGHTS by how it was built.
%
% CALL: liggghtsBuilds (WORK, NSEEDS)
%
% WORK    text, folder of the runs and of the profile; finished runs in it are
%         reused
% NSEEDS  number of packings, at most 8
%
% The container Lift100 and the drum, each with the same number of steps for all
% programs (the container waits 0.3 s and 0.7 s instead of for its criteria):
%   debian    /usr/bin/liggghts of Debian's package, if it is there
%   ours      this toolbox's build with its own flags
%   linkTime  the same with -flto
%   profile   the same, with the profile of one run of each bench
% The programs are built by tools/liggghts/build.sh, some minutes each on two
% cores, and stay in its cache: LIGGGHTS=<printed path> chooses one. Packings
% are outside and programs inside the loop, so a machine that gets busier slows
% all alike. Prints the user time of the programs over that of ours, mean and
% 95 % interval over the packings, and writes
% benchmarks/results/liggghtsBuilds.csv.
%
% See also: benchRun, mweWaits

function liggghtsBuilds (work, nSeeds)
  root = startBenchmarks ();
  [~, ~] = mkdir (work);
  programs = builtPrograms (make_absolute_filename (work), root);
  list = programs';
  printf ('%s: %s/liggghts\n', list{:});
  benches = {'Lift100', struct('useCriteria', 0, 'settleTime', 0.3, ...
                               'dischargeTime', 0.7); 'Drum', struct()};
  seeds = benchSeeds (1:nSeeds);
  fid = fopen (fullfile (root, 'benchmarks', 'results', ...
                         'liggghtsBuilds.csv'), 'w');
  fprintf (fid, "bench,seed,program,seconds\n");
  for b = 1:rows (benches)
    seconds = zeros (nSeeds, rows (programs));
    for s = 1:nSeeds
      for p = 1:rows (programs)
        seconds(s, p) = secondsOf (work, benches(b, :), seeds(s), ...
                                   programs(p, :));
        fprintf (fid, "%s,%d,%s,%.3f\n", benches{b, 1}, seeds(s), ...
                 programs{p, 1}, seconds(s, p));
        fflush (fid);
      end
    end
    printf ('%s\n', benches{b, 1});
    sayRatios (programs(:, 1), seconds, 'ours');
  end
  fclose (fid);
end

% PROGRAMS  n x 2 cell: name, folder of the program
function programs = builtPrograms (work, root)
  plain = '-O3 -march=native -ffp-contract=off';
  % build.sh compiles in a folder of a new name each time: make puts it in here
  place = [fullfile(work, 'profile'), ' -fprofile-prefix-path=$(CURDIR)'];
  programs = {'ours', build(root, plain); ...
              'linkTime', build(root, [plain, ' -flto=auto'])};
  trainer = build (root, [plain, ' -fprofile-generate=', place]);
  train (work, root, trainer);
  programs(end + 1, :) = {'profile', ...
                          build(root, [plain, ' -fprofile-use=', place, ...
                                       ' -fprofile-partial-training'])};
  if isfile ('/usr/bin/liggghts')
    programs = [{'debian', '/usr/bin'}; programs];
  end
end

function folder = build (root, flags)
  tools = fullfile (root, 'tools', 'liggghts');
  [status, folder] = system (sprintf (['export LIGGGHTS_CXXFLAGS=''%s''; ', ...
                                       'unset LIGGGHTS; "%s/build.sh" 1>&2', ...
                                       ' && "%s/path.sh"'], flags, tools, ...
                                      tools));
  if status ~= 0
    error ('DEcalioc:liggghtsBuilds:runFailed', ...
           'liggghtsBuilds: LIGGGHTS must build with %s.', flags);
  end
  folder = strtrim (folder);
end

function train (work, root, folder)
  benches = readdir (fullfile (root, 'DEMmodels'));
  for bench = benches(~strncmp (benches, '.', 1))'
    benchRun (fullfile (work, ['train-', bench{1}]), bench{1}, struct (), ...
              sprintf ('export PATH="%s:$PATH"', folder));
  end
end

function seconds = secondsOf (work, bench, seed, program)
  folder = fullfile (work, sprintf ('%s-%s-%d', bench{1}, program{1}, seed));
  [~, seconds] = benchRun (folder, bench{1}, ...
                           setfield (bench{2}, 'runSeed', seed), ...
                           sprintf ('export PATH="%s:$PATH"', program{2}));
end
