% BENCHLAWS  Holds the benches against published laws.
%
% CALL: benchLaws (WORK, NSEEDS)
%
% WORK    text, folder of the runs; finished runs in it are reused
% NSEEDS  number of seeds
%
% Writes benchmarks/results/benchLaws.csv: law, at, value, sd of the mean, and
% the fitted exponents beside the published ones.
%   drum      slope of the free surface against speed: it rises
%   collapse  run-out / length against aspect ratio a of the column: exponent 1
%             for small a, 2/3 for large a (Lube et al. 2005, Lajeunesse et al.
%             2005, planar columns)
%   slot      discharge against opening: (B - k d)^(3/2) (Beverloo for slots),
%             k = 1.4
%
% See also: effectSigns, benchRun
function benchLaws (work, nSeeds)
  root = fileparts (fileparts (mfilename ('fullpath')));
  fid = fopen (fullfile (root, 'benchmarks', 'results', 'benchLaws.csv'), 'w');
  fprintf (fid, "law,at,value,standardError,published\n");
  drumLaw (fid, work, nSeeds);
  collapseLaw (fid, work, nSeeds);
  slotLaw (fid, work, nSeeds);
  fclose (fid);
end

function drumLaw (fid, work, n)
  rows = runsOf (work, 'Drum', '-0', struct (), n);
  writeCurve (fid, 'drum slope (deg) at rad/s', [2, 4, 8], rows(:, [1, 4, 7]));
  rise = mean (rows(:, 7)) - mean (rows(:, 1));
  fprintf (fid, "drum slope rise (deg),,%.3g,,positive\n", rise);
end

function collapseLaw (fid, work, n)
  solids = [0.011, 0.022, 0.044, 0.088];
  aspect = zeros (1, 4);
  runOut = zeros (n, 4);
  for k = 1:4
    set = struct ('columnSolid', solids(k));
    rows = runsOf (work, 'Collapse', sprintf ('solid-%g', solids(k)), set, n);
    runOut(:, k) = rows(:, 2) / 0.04;
    fill = mean (rows(:, 1)) / 1200;
    aspect(k) = solids(k) / fill / 0.04;
  end
  writeCurve (fid, 'collapse run-out / length at aspect ratio', aspect, runOut);
  mean1 = mean (runOut, 1);
  low = log (mean1(2) / mean1(1)) / log (aspect(2) / aspect(1));
  high = log (mean1(4) / mean1(3)) / log (aspect(4) / aspect(3));
  fprintf (fid, "collapse exponent below a = 1,,%.3g,,1\n", low);
  fprintf (fid, "collapse exponent above a = 2,,%.3g,,0.667\n", high);
end

function slotLaw (fid, work, n)
  narrow = runsOf (work, 'SlotBin', '-0', struct (), n);
  other = runsOf (work, 'SlotBin', 'slots-25-36', ...
                  struct ('slot1', 0.025, 'slot2', 0.036), n);
  opening = [0.02, 0.025, 0.03, 0.036];
  rate = [narrow(:, 1), other(:, 1), narrow(:, 4), other(:, 4)];
  writeCurve (fid, 'slot discharge (kg/s) at opening (m)', opening, rate);
  clear1 = opening - 1.4 * 0.004;
  line = polyfit (log (clear1), log (mean (rate, 1)), 1);
  fprintf (fid, "slot exponent of B - 1.4 d,,%.3g,,1.5\n", line(1));
end

function writeCurve (fid, name, at, rows)
  for k = 1:numel (at)
    fprintf (fid, "%s,%.3g,%.4g,%.2g,\n", name, at(k), mean (rows(:, k)), ...
             std (rows(:, k)) / sqrt (size (rows, 1)));
  end
end

function results = runsOf (work, bench, tag, variables, n)
  seeds = [10007, 10009, 10037, 10039, 10061, 10067, 10069, 10079];
  results = [];
  for seed = seeds(1:n)
    variables.runSeed = seed;
    folder = fullfile (work, sprintf ('%s-%s-%d', bench, tag, seed));
    results = [results; benchRun(folder, bench, variables)];
  end
end
