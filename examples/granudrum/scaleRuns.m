% SCALERUNS  What the size of the grains does to the simulated surfaces.
%
% CALL: octave-cli scaleRuns.m [NEW]
%
% NEW  DEM runs that may be made (2); 0: only those of scaleRuns.csv
%
% The set of predictionSets.csv that is nearest to the measurement, with grains
% twice instead of three times too large (modelVars.grainScale), one packing
% after another. Writes scaleRuns.csv, with the columns of runs.csv. Prints rms
% of measured minus simulated at both scales; the same for grains of real size
% if the surface went on as it did from 3 to 2; and the cosine of that change
% with the change by each effect (full strength, at the same set or the nearest
% one that was run with it).
%
% See also: compareSurfaces, drawPredictionSets

1;

function data = scaledRuns (Case, folder, X, n)
  Case.modelVars.grainScale = 2;
  Case.store = fullfile (folder, 'results', 'scale');
  Case.options.maxNewRuns = n;
  [~, ~] = mkdir (fullfile (folder, 'results'));
  [~, ~] = mkdir (Case.store);
  Z = evaluateDEM (repmat (X, n, 1), Case, (1:n)', 'gap', ...
                   newProgress ('gap', @disp));
  there = all (isfinite (Z), 2);
  data = struct ('X', repmat (X, sum (there), 1), 'Z', Z(there, :), ...
                 'E', repmat (neutralEffects (Case), sum (there), 1), ...
                 'replicate', find (there));
  exportRuns (fullfile (folder, 'scaleRuns.csv'), Case, data);
end

function sayMiss (text, off)
  n = numel (off) / 2;
  printf ('| %s | %.2f | %.2f | %.2f | %.2f |\n', text, ...
          norm (off(1:n)) / sqrt (n), norm (off(n + 1:end)) / sqrt (n), ...
          mean (off(1:n)), mean (off(n + 1:end)));
end

function sayAlike (Case, data, X, base, change)
  neutral = neutralEffects (Case);
  half = diff (Case.limits) / 2;
  for j = 1:numel (neutral)
    own = find (data.E(:, j) ~= neutral(j) & ...
                sum (data.E ~= neutral, 2) == 1 & ...
                sumsq ((data.X - X) ./ half, 2) < 0.01);
    for i = own'
      d = data.Z(i, :) - base;
      sayCosine (sprintf ('%s %g', Case.effectVars{j}, data.E(i, j)), ...
                 d, change);
    end
  end
  info = targetInfo (Case);
  for e = Case.effects([Case.effects.laboratory])
    d = e.transform (base, e.limits(2), info) - base;
    sayCosine (sprintf ('%s %g', e.name, e.limits(2)), d, change);
  end
end

function sayCosine (text, d, change)
  printf ('%s: cosine %.2f\n', text, d * change' / norm (d) / norm (change));
end

function result = compareScales (root, folder)
  useLiggghts (root);
  nNew = 2;
  if ~isempty (argv ()) && isfinite (str2double (argv (){end}))
    nNew = str2double (argv (){end});
  end
  Case = withEffects (loadCase (root, folder));
  [~, cells] = readCsvTable (fullfile (folder, 'predictionSets.csv'));
  X = str2double (cells(1, 2:end));
  if nNew > 0
    fine = scaledRuns (Case, folder, X, nNew);
  else
    fine = importRuns (fullfile (folder, 'scaleRuns.csv'), Case);
  end
  data = gatherRuns (Case);
  at = all (abs (data.X - X) < 1e-9, 2) & ...
       all (data.E == neutralEffects (Case), 2);
  y = [Case.targets.value];
  base = mean (data.Z(at, :), 1);
  change = mean (fine.Z, 1) - base;
  puts ("| grains too large by | rms at 15 rpm | at 45 rpm | mean | mean |\n");
  puts ("|---|---|---|---|---|\n");
  sayMiss (sprintf ('3 (%d packings)', sum (at)), y - base);
  sayMiss (sprintf ('2 (%d packings)', rows (fine.Z)), y - base - change);
  sayMiss ('1, carried on by a straight line', y - base - 2 * change);
  sayAlike (Case, data, X, base, change);
  result.exitStatus = 0;
end

here = fileparts (mfilename ('fullpath'));
root = fileparts (fileparts (here));
addpath (fullfile (root, 'infrastructure'));
startMain (@compareScales, root);

% SPDX-License-Identifier: GPL-3.0-only
