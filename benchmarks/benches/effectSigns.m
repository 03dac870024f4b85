% EFFECTSIGNS  Measures what each effect does to each result of each bench.
%
% CALL: effectSigns (WORK, BENCHES, NNULL, NFULL)
%       effectSigns (WORK, BENCHES, NNULL, NFULL, ONLYFINISHED, NAMES)
%
% WORK     text, folder of the runs; finished runs in it are reused
% BENCHES  cell of names of benches
% NNULL    number of seeds without effects; 0: mean and sd are those of
%          benchNoise.csv, which stays as it is
% NFULL    number of seeds at full strength (the limit farther from neutral,
%          the upper one where both are as far)
% ONLYFINISHED  true: no run is made, the finished ones count (default false)
% NAMES    cell of names of effects: of all others, and on other benches, the
%          lines of the table stay
%
% Writes benchmarks/results/effectSigns.csv (effect, strength, bench, target,
% change, noiseSd, z = change / noiseSd, sign: 0 where the change is below two
% standard errors; target none and sign failed where no run came to its end) and
% benchNoise.csv (bench, target, unit, mean, sd of one run, relative sd,
% spheres, CPU seconds). An effect of the laboratory acts on the means of the
% null runs, no run is made for it. A share of a commanded tilt is measured where
% one is commanded: 10 degrees, also in the runs without the effect.
%
% About an hour of one core with 8 and 2 seeds.
%
% See also: benchRun, benchTables
function effectSigns (work, benches, nNull, nFull, onlyFinished, names)
  if nargin < 5
    onlyFinished = false;
  end
  if nargin < 6
    names = listEffects ();
  end
  place = struct ('work', work, 'onlyFinished', onlyFinished);
  root = startBenchmarks ();
  folder = fullfile (root, 'benchmarks', 'results');
  effects = resolveEffects (listEffects ());
  kept = linesBut (fullfile (folder, 'effectSigns.csv'), names, benches);
  [~, known] = readCsvTable (fullfile (folder, 'benchNoise.csv'));
  signs = fopen (fullfile (folder, 'effectSigns.csv'), 'w');
  noise = fopen ({fullfile(folder, 'benchNoise.csv'), ...
                  '/dev/null'}{1 + (nNull == 0)}, 'w');
  made = strjoin (originLines (), "\n");
  fprintf (signs, "%s\neffect,strength,bench,target,change,noiseSd,z,sign\n%s", ...
           made, kept);
  fprintf (noise, "%s\nbench,target,unit,mean,sd,relativeSd,spheres,seconds\n", ...
           made);
  for b = 1:numel (benches)
    source = fullfile (root, 'DEMmodels', benches{b});
    info = resultInfo (source);
    if nNull == 0
      plain = twoRows (known(strcmp (known(:, 1), benches{b}), 4:5));
    else
      [plain, cost] = runsOf (place, benches{b}, {}, 0, 1:nNull);
      writeNoise (noise, benches{b}, info, plain, cost);
    end
    can = effectsOfModel (source, effects);
    for e = effects(can & ismember ({effects.name}, names))
      strength = fullStrength (e);
      null = plain;
      if e.laboratory
        full = e.transform (mean (null), strength, info);
        full = repmat (full, size (null, 1), 1);
      elseif strcmp (e.name, 'tiltShare')
        null = runsOf (place, benches{b}, {'tiltCommanded'}, 10, ...
                       1:max (nNull, 4));
        full = runsOf (place, benches{b}, {e.variables{1}, ...
                                           'tiltCommanded'}, [strength, 10], (1:nFull) + 4);
      else
        full = runsOf (place, benches{b}, e.variables(1), strength, ...
                       (1:nFull) + 4);
      end
      writeSigns (signs, {e.name, strength, benches{b}}, info, {null, full});
    end
  end
  fclose (signs);
  fclose (noise);
end

function text = linesBut (file, names, benches)
  [~, rest] = originOf (file);
  lines = strsplit (rest, "\n")(2:end - 1);
  words = cellfun (@(l) strsplit (l, ','), lines, 'UniformOutput', false);
  isNew = cellfun (@(w) any (strcmp (w{1}, names)) && ...
                   any (strcmp (w{3}, benches)), words);
  text = sprintf ("%s\n", lines{~isNew});
end

% With this mean and standard deviation (texts, a row a target).
function plain = twoRows (numbers)
  numbers = str2double (numbers)';
  plain = numbers(1, :) + [-1; 1] / sqrt (2) * numbers(2, :);
end

function strength = fullStrength (effect)
  distance = abs (effect.limits(:, 1) - effect.neutral(1));
  far = 2 - (distance(1) > 1.001 * distance(2));
  strength = effect.limits(far, 1);
end

% COST: spheres and CPU seconds, means over the runs
function [results, cost] = runsOf (place, bench, names, values, which)
  results = [];
  cost = zeros (0, 2);
  for seed = benchSeeds (which)
    variables = struct ('runSeed', seed);
    for k = 1:numel (names)
      variables.(names{k}) = values(k);
    end
    folder = fullfile (place.work, ...
                       sprintf ('%s-%s%s-%d', bench, strjoin (names, '-'), ...
                                sprintf ('-%g', values), seed));
    if ~place.onlyFinished || isfile (fullfile (folder, 'output_checks.csv'))
      [row, time] = benchRun (folder, bench, variables);
      if isfile (fullfile (folder, 'output_checks.csv'))
        results = [results; row];
        cost = [cost; readChecks(folder).spheresStart, time];
      end
    end
  end
  results = results(~any (isnan (results), 2), :);
  cost = mean (cost, 1);
end

function writeNoise (fid, bench, info, null, cost)
  for t = 1:numel (info)
    m = mean (null(:, t));
    s = std (null(:, t));
    fprintf (fid, "%s,%s,%s,%.5g,%.3g,%.3g,%d,%.1f\n", bench, ...
             info(t).name, info(t).unit, m, s, s / abs (m), cost);
  end
end

function writeSigns (fid, words, info, rows)
  [null, full] = rows{:};
  if isempty (full)
    fprintf (fid, "%s,%g,%s,none,NaN,NaN,NaN,failed\n", words{:});
    return
  end
  change = mean (full, 1) - mean (null, 1);
  sd = std (null, 0, 1);
  error1 = sd * sqrt (1 / size (full, 1) + 1 / size (null, 1));
  marks = {'-', '0', '+'};
  for t = 1:numel (info)
    mark = marks{2 + sign(change(t)) * (abs (change(t)) > 2 * error1(t))};
    fprintf (fid, "%s,%g,%s,%s,%.4g,%.3g,%.3g,%s\n", words{:}, ...
             info(t).name, change(t), sd(t), change(t) / sd(t), mark);
  end
end

%!test % the measured table of signs holds every result of a bench on which an
%! % effect was measured, and each moves something by more than 3 standard
%! % deviations
%! root = startBenchmarks ();
%! [~, table] = readCsvTable (fullfile (root, 'benchmarks', 'results', ...
%!                                      'effectSigns.csv'));
%! z = abs (str2double (table(:, 7)));
%! effects = resolveEffects (listEffects ());
%! for bench = unique (table(:, 3))'   % a new bench is not measured yet
%!   folder = fullfile (root, 'DEMmodels', bench{1});
%!   for e = effects(effectsOfModel (folder, effects))
%!     at = strcmp (table(:, 1), e.name) & strcmp (table(:, 3), bench{1});
%!     has = ismember (sum (at), [0, numel(resultInfo (folder))]) || ...
%!           strcmp (table(at, 8), 'failed');
%!     assert (has, [e.name, ' ', bench{1}]);
%!   end
%! end
%! for e = effects
%!   seen = strcmp (table(:, 1), e.name) & z > 3 & isfinite (z);
%!   assert (any (seen), e.name);
%! end

% SPDX-License-Identifier: GPL-3.0-only
