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
  root = startBenchmarks ();
  fid = fopen (fullfile (root, 'benchmarks', 'results', 'benchLaws.csv'), 'w');
  fprintf (fid, "%s\n", originLines (){:});
  fprintf (fid, "law,at,value,standardError,published\n");
  drumLaw (fid, work, nSeeds);
  collapseLaw (fid, work, min (nSeeds, 2));
  slotLaw (fid, work, nSeeds);
  fclose (fid);
end

function drumLaw (fid, work, n)
  slope = named (benchRuns (fullfile (work, 'Drum--0'), 'Drum', ...
                            struct (), n), 'Drum', ...
                 {'slope1', 'slope2', 'slope3'});
  writeCurve (fid, 'drum slope (deg) at rad/s', [2, 4, 8], slope);
  rise = mean (slope(:, 3)) - mean (slope(:, 1));
  fprintf (fid, "drum slope rise (deg),,%.3g,,positive\n", rise);
end

% Finer grains than the bench's own (2.5 mm, 16 of them along the column), and a
% front as the papers see it; the bench's own runOut leaves out the last 3 % of
% the grains, which scatters less and is shorter.
function collapseLaw (fid, work, n)
  aspects = [0.5, 1, 1.5, 3, 5, 8];
  length1 = 0.04;
  set = struct ('radiusP', 1.25e-3, 'columnWidth', 0.01, ...
                'columnLength', length1);
  runOut = zeros (n, 6);
  for k = 1:6
    set.columnSolid = 0.55 * aspects(k) * length1;
    tag = sprintf ('fine-%g-%g', length1, aspects(k));
    [~, folders] = benchRuns (fullfile (work, ['Collapse-', tag]), ...
                              'Collapse', set, n);
    for i = 1:n
      grains = readDump (fullfile (folders{i}, 'deposit.dump')){end};
      runOut(i, k) = frontOf (grains, set.columnWidth) / length1 - 1;
    end
  end
  writeCurve (fid, 'collapse run-out / length at aspect ratio', aspects, ...
              runOut);
  writeExponent (fid, 'collapse exponent for a < 1.8', aspects, runOut, ...
                 aspects < 1.8, '1');
  writeExponent (fid, 'collapse exponent for a > 2.8', aspects, runOut, ...
                 aspects > 2.8, '0.667');
  writeExponent (fid, 'collapse exponent for a > 4', aspects, runOut, ...
                 aspects > 4, '0.667');
  shallow = aspects < 1.8;
  factor = mean (mean (runOut(:, shallow), 1) ./ aspects(shallow));
  fprintf (fid, "collapse factor of a for a < 1.8,,%.3g,,1.2 to 1.8\n", ...
           factor);
end

% The deposit ends where, over a length of two grains, less than half of the
% floor is covered: single grains that rolled on do not count.
function front = frontOf (grains, width)
  d = 2 * median (grains(:, 4));
  edges = 0:d / 2:max (grains(:, 1)) + 4 * d;
  full = 2 * width / (pi / 4 * d);
  count = arrayfun (@(x) sum (grains(:, 1) >= x & grains(:, 1) < x + 2 * d), ...
                    edges);
  front = edges(find (count < full / 2, 1)) + d;
end

% Slope of the logarithms, and its standard error over the seeds.
function writeExponent (fid, name, at, rows, use, published)
  n = size (rows, 1);
  slope = zeros (n, 1);
  for i = 1:n
    slope(i) = polyfit (log (at(use)), log (rows(i, use)), 1)(1);
  end
  fprintf (fid, "%s,,%.3g,%.2g,%s\n", name, mean (slope), ...
           std (slope) / sqrt (n), published);
end

% Two slots a run: the narrow and the wide one of the bench, and two between.
function slotLaw (fid, work, n)
  narrow = benchRuns (fullfile (work, 'SlotBin--0'), 'SlotBin', struct (), n);
  other = benchRuns (fullfile (work, 'SlotBin-slots-25-36'), 'SlotBin', ...
                     struct ('slot1', 0.025, 'slot2', 0.036), n);
  opening = [0.02, 0.025, 0.03, 0.036];
  two = {'rate1', 'rate2'};
  rate = [named(narrow, 'SlotBin', two), named(other, 'SlotBin', two)];
  rate = rate(:, [1, 3, 2, 4]);
  writeCurve (fid, 'slot discharge (kg/s) at opening (m)', opening, rate);
  all1 = true (1, 4);
  writeExponent (fid, 'slot exponent of B - 1.4 d', opening - 1.4 * 0.004, ...
                 rate, all1, '1.5');
  % one edge of these slots is a vertical wall: half of the empty margin
  writeExponent (fid, 'slot exponent of B - 0.7 d', opening - 0.7 * 0.004, ...
                 rate, all1, '1.5');
  % W^(2/3) is a straight line over B; where it meets zero is k d
  k = zeros (n, 1);
  for i = 1:n
    line = polyfit (opening, rate(i, :).^(2 / 3), 1);
    k(i) = -line(2) / line(1) / 0.004;
  end
  fprintf (fid, "slot k of (B - k d)^1.5,,%.3g,%.2g,1.4 to 1.5\n", ...
           mean (k), std (k) / sqrt (n));
end

% The columns of results of a bench that have these names.
function results = named (results, bench, names)
  folder = fullfile (startBenchmarks (), 'DEMmodels', bench);
  [~, at] = ismember (names, {resultInfo(folder).name});
  results = results(:, at);
end

function writeCurve (fid, name, at, rows)
  for k = 1:numel (at)
    fprintf (fid, "%s,%.3g,%.4g,%.2g,\n", name, at(k), mean (rows(:, k)), ...
             std (rows(:, k)) / sqrt (size (rows, 1)));
  end
end

% SPDX-License-Identifier: GPL-3.0-only
