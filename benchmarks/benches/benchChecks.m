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
% See also: effectSigns, benchRun, benchLarger
function benchChecks (work, benches, nulls, nSeeds)
  root = startBenchmarks ();
  fid = fopen (fullfile (root, 'benchmarks', 'results', ...
                         'benchChecks.csv'), 'w');
  fprintf (fid, "%s\n", originLines (){:});
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
    [variables, growth] = benchLarger (bench{1});
    large = benchRuns (stem ('largerSystem'), bench{1}, variables, nSeeds);
    large = large ./ growth;
    writeRows (fid, {bench{1}, 'halfStep'}, info, null, half);
    writeRows (fid, {bench{1}, 'largerSystem'}, info, null, large);
  end
  fclose (fid);
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

% SPDX-License-Identifier: GPL-3.0-only
