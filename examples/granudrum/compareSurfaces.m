% COMPARESURFACES  Prints how far simulated surfaces are from the measured ones.
%
% CALL: octave-cli compareSurfaces.m [OFFSET]
%
% Root mean square of z over the 27 places of measured.csv, |x| <= 26 mm, at 15
% and 45 rpm: the best trial of ACCES (acces.csv), and of runs.csv the set
% without effects that was run most often (mean of its packings), the set that
% is nearest at 15 rpm, at 45 rpm and over both. Then the sets that
% diagnoseGap.m compared (cureRuns.csv), those of optics by a surface that is
% read OFFSET mm (0) further out.
%
% See also: surfaceMiss, predictSurfaces, measureBench

1;

function sayRow (text, n, rms, params)
  printf ('| %s | %d | %.2f | %.2f | %s |\n', text, n, rms, ...
          strjoin (arrayfun (@(p) sprintf ('%.3f', p), params, ...
                             'UniformOutput', false), ', '));
end

function compareCures (Case, file, offset)
  runs = importRuns (file, Case);
  y = [Case.targets.value];
  n = numel (y) / 2;
  out = offset ./ [repmat(cosd (41), 1, n), repmat(cosd (55), 1, n)];
  [sets, ~, which] = unique ([runs.X, runs.E], 'rows');
  for k = 1:rows (sets)
    z = mean (runs.Z(which == k, :), 1);
    x = sets(k, 1:numel (Case.names));
    isPlain = isequal (sets(k, numel (x) + 1:end), neutralEffects (Case));
    text = 'compared';
    if ~isPlain
      text = 'compared, with an effect';
    end
    sayRow (text, sum (which == k), surfaceMiss (z, y), x);
    if isPlain && offset ~= 0
      sayRow (sprintf ('the same, read %.2f mm out', offset), ...
              sum (which == k), surfaceMiss (z + out, y), x);
    end
  end
end

function result = compareCase (root, folder)
  useLiggghts (root);
  Case = withEffects (loadCase (root, folder));
  y = [Case.targets.value];
  [~, cells] = readCsvTable (fullfile (folder, 'acces.csv'));
  printf ('| set | runs | rms at 15 rpm | at 45 rpm | %s |\n', ...
          strjoin (Case.names, ', '));
  puts ("|---|---|---|---|---|\n");
  acces = str2double (cells(:, 3))';
  sayRow ('best trial of ACCES', 1, surfaceMiss (acces, y), [0.561, 0.293]);
  data = gatherRuns (Case);
  plain = all (data.E == neutralEffects (Case), 2) & ...
          all (isfinite (data.Z), 2);
  [X, ~, which] = unique (data.X(plain, :), 'rows');
  Z = data.Z(plain, :);
  count = accumarray (which, 1);
  mean_ = zeros (rows (X), columns (Z));
  for k = 1:rows (X)
    mean_(k, :) = mean (Z(which == k, :), 1);
  end
  rms = surfaceMiss (mean_, y);
  [~, most] = max (count);
  [~, slow] = min (rms(:, 1));
  [~, fast] = min (rms(:, 2));
  [~, both] = min (sumsq (rms, 2));
  texts = {'most packings', 'nearest at 15 rpm', 'nearest at 45 rpm', ...
           'nearest over both'};
  at = [most, slow, fast, both];
  for i = 1:4
    sayRow (texts{i}, count(at(i)), rms(at(i), :), X(at(i), :));
  end
  given = [argv()', {'0'}];
  compareCures (Case, fullfile (folder, 'cureRuns.csv'), str2double (given{1}));
  printf ('%d runs without effects, %d with\n', sum (plain), ...
          rows (data.X) - sum (all (data.E == neutralEffects (Case), 2)));
  result.exitStatus = 0;
end

here = fileparts (mfilename ('fullpath'));
root = fileparts (fileparts (here));
addpath (fullfile (root, 'infrastructure'));
startMain (@compareCase, root);

% SPDX-License-Identifier: GPL-3.0-only
