% BENCHCHECKS  Halves the time step and enlarges the system of each bench.
%
% CALL: benchChecks (WORK, BENCHES, NULLS, NSEEDS)
%
% WORK     text, folder of the runs; finished runs in it are reused
% BENCHES  cell of names of benches
% NULLS    number of null runs in WORK (of effectSigns) to compare with
% NSEEDS   number of seeds of each changed bench
%
% Writes benchmarks/results/benchChecks.csv: bench, check (halfStep,
% largerSystem, seeds), target, null, changed, noiseSd, z = change / noiseSd,
% and whether the change is below 2 noise standard deviations. The larger
% system is 1.5 times as deep or long (Collapse 5/3 times, a whole number of
% glued grains; Heap 1.5 times the volume, its lengths and mass scaled back).
%
% See also: effectSigns, benchRun
function benchChecks (work, benches, nulls, nSeeds)
  root = startBenchmarks ();
  fid = fopen (fullfile (root, 'benchmarks', 'results', ...
                         'benchChecks.csv'), 'w');
  fprintf (fid, ['bench,check,target,null,changed,noiseSd,z,' ...
                 'belowTwoSd\n']);
  for bench = benches
    source = fullfile (root, 'DEMmodels', bench{1});
    info = resultInfo (source);
    head = headDefaults (fullfile (source, 'data.head'));
    stem = @(check) fullfile (work, [bench{1}, '-', check]);
    null = benchRuns (stem ('-0'), bench{1}, struct (), nulls);
    half = benchRuns (stem ('halfStep'), bench{1}, ...
                      struct ('percentRayleigh', head.percentRayleigh / 2), ...
                      nSeeds);
    [variables, unit] = largerOf (bench{1});
    large = benchRuns (stem ('largerSystem'), bench{1}, variables, nSeeds);
    large = large ./ unit;
    writeRows (fid, {bench{1}, 'halfStep'}, info, null, half);
    writeRows (fid, {bench{1}, 'largerSystem'}, info, null, large);
  end
  fclose (fid);
end

function [variables, unit] = largerOf (bench)
  unit = 1;
  switch bench
    case 'Collapse'
      variables = struct ('columnWidth', 0.08 / 3, 'glueColumns', 5);
    case 'Drum'
      variables = struct ('drumWidth', 0.018);
    case 'Heap'
      k = 1.5^(1 / 3);
      variables = struct ('tubeRadius', 0.015 * k, 'plateRadius', ...
                          0.032 * k, 'heapSolid', 1.5 * 1.9e-5, ...
                          'liftHeight', 0.06 * k, 'liftSpeed', 0.12 * sqrt (k));
      unit = [1, k, 1.5, k];
    case 'Shear'
      variables = struct ('cellLength', 0.048);
    case 'SlotBin'
      variables = struct ('binWidth', 0.018, 'glueColumns', 3);
      unit = [1.5, 1.5, 1, 1.5, 1.5, 1];
  end
end

function writeRows (fid, words, info, null, changed)
  sd = std (null, 0, 1);
  before = mean (null, 1);
  after = mean (changed, 1);
  z = (after - before) ./ sd;
  answers = {'no', 'yes'};
  for t = 1:numel (info)
    fprintf (fid, "%s,%s,%s,%.5g,%.5g,%.3g,%.2f,%s\n", words{:}, ...
             info(t).name, before(t), after(t), sd(t), z(t), ...
             answers{1 + (abs (z(t)) < 2)});
  end
end
