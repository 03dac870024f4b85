% LIFT100STOP  When may the discharge of the container Lift100 be ended?
%
% CALL: lift100Stop (WORK, NSEEDS)
%
% WORK    text, folder of the runs; finished runs in it are reused
% NSEEDS  number of packings
%
% Two sets at the limits of the default case (free-flowing: lowest friction and
% rolling friction; rough: highest), each packing once, up to the limit of 4 s
% of discharge. At every look (0.05 s) a run notes the time, the mass inside,
% the spheres inside, the kinetic energy over m g r, and the core time it has
% taken so far. A criterion is then tried on the stored curves (stopTable).
% Writes benchmarks/results/lift100Stop.csv: set, seed, time (s), mass (kg),
% spheres, energy, coreSeconds, a row every 0.1 s; and prints the table. A run
% takes about a core-minute on a busy machine.
%
% See also: stopTable, mweWaits

function lift100Stop (work, nSeeds)
  root = startBenchmarks ();
  file = fullfile (root, 'benchmarks', 'results', 'lift100Stop.csv');
  model = watchedModel (root, fullfile (work, 'model'));
  sets = {'free', 0.3, 0.025; 'rough', 0.7, 0.075};
  seeds = primes (11000);
  seeds = seeds(seeds > 10000)(1:nSeeds);
  fid = fopen (file, 'w');
  fprintf (fid, "set,seed,time,mass,spheres,energy,coreSeconds\n");
  % packings outside: a machine that gets busier then slows both sets alike
  for seed = seeds
    for i = 1:rows (sets)
      curve = oneCurve (work, model, sets(i, :), seed);
      fprintf (fid, [sets{i, 1}, ',', sprintf('%d', seed), ...
                     ",%.2f,%.6g,%d,%.3g,%.2f\n"], curve(2:2:end, :)');
      fflush (fid);
    end
  end
  fclose (fid);
  stopTable (file);
end

% The model with a line of more columns a look, and never an end by rest.
function model = watchedModel (root, model)
  [~, ~] = mkdir (model);
  copyfile (fullfile (root, 'DEMmodels', 'Lift100', '*'), model);
  script = fullfile (model, 'in.Lift100');
  text = fileread (script);
  plain = 'print "${flowSpent},${massIn}" append discharge_curve.csv';
  watched = ['print "${flowSpent},${massIn},${nNow},${restBefore}" append ', ...
             "looks.csv screen no\nshell sh coreTime.sh\n", plain];
  assert (numel (strfind (text, plain)), 1);
  writeAtomic (script, strrep (text, plain, watched));
  head = fullfile (model, 'data.head');
  writeAtomic (head, [fileread(head), "variable quietTime equal 1e3\n"]);
  % ticks of the processor that liggghts, a shell or two above, has taken
  writeAtomic (fullfile (model, 'coreTime.sh'), ...
               ["pid=$PPID\n", ...
                "until grep -q '(liggghts)' /proc/$pid/stat; do\n", ...
                "  pid=$(cut -d ' ' -f 4 /proc/$pid/stat)\ndone\n", ...
                "set -- $(cat /proc/$pid/stat)\n", ...
                "echo $((${14} + ${15})) >> ticks\n"]);
end

% n x 5: time, mass, spheres, energy, core seconds so far
function curve = oneCurve (work, model, set, seed)
  folder = fullfile (work, sprintf ('%s-%d', set{1}, seed));
  if ~isfile (fullfile (folder, 'output_mass'))
    confirm_recursive_rmdir (false, 'local');
    [~, ~] = rmdir (folder, 's');
    copyfile (model, folder);
    variables = struct ('densityP', 650, 'coefFrictionPP', set{2}, ...
                        'coefFrictionPW', set{2}, ...
                        'coefRollingFrictionPP', set{3}, 'runSeed', seed);
    lines = cellfun (@(name) sprintf ("variable %s equal %g\n", name, ...
                                      variables.(name)), ...
                     fieldnames (variables)', 'UniformOutput', false);
    head = fullfile (folder, 'data.head');
    writeAtomic (head, [fileread(head), lines{:}]);
    system (sprintf (['cd "%s" && OMPI_MCA_ess_singleton_isolated=1 ', ...
                      'bash runscript > out 2> err < /dev/null'], folder));
  end
  [~, ticksPerSecond] = system ('getconf CLK_TCK');
  curve = [csvread(fullfile (folder, 'looks.csv')), ...
           load(fullfile (folder, 'ticks')) / str2double(ticksPerSecond)];
end
