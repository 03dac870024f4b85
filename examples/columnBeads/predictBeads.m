% PREDICTBEADS  Predicts the deposits of beads of 6 and 10 mm.
%
% CALL: octave-cli predictBeads.m
%
% From sealedCauses.csv and the stored runs (runPredictions.m), without further ones.
% Writes prediction.csv, of each series rows of
%   reference   the model without an effect, mean over the sets that fit
%   NAME        the same sets with the cause NAME of sealedCauses.csv
%   best        the causes together, weighted by their probability (reference,
%               where nothing changed), and what the series' own measurements at
%               4 and 8 mm miss, carried to the other size
%
% The residual is taken as a random walk in the logarithm of the size, whose
% step for a factor of two is learned from all series: at 6 mm the mean of both,
% weighted, at 10 mm that of 8 mm. The 90 % interval is to hold the mean of two
% trials. That of reference and NAME is about their own value and so wide that
% it holds what best says.
%
% Prints how far each line of sealedCauses.csv closes the measured change at 4 and 8
% mm (targets taken singly): 1 less the squares that remain over those that
% were, each less what the scatter of the trials makes.
%
% See also: runPredictions, seriesMeans

1;

% Results of the sets, in their order; NaN where a set was not run
function Z = resultsOf (file, Case, sets)
  data = importRuns (file, Case);
  Z = NaN (rows (sets), numel (Case.targets));
  known = [data.X, data.E];
  for i = 1:rows (sets)
    same = abs (known - sets(i, :)) <= 1e-6 * (1 + abs (known));
    at = find (all (same, 2), 1);
    if ~isempty (at)
      Z(i, :) = data.Z(at, :);
    end
  end
end

% 23 quantities of the targets of one model: angles, length, height, profile
function at = quantities (targets)
  at = zeros (1, 0);
  for name = {'toeAngle', 'topAngle', 'length', 'height'}
    at(end + 1) = find (strcmp ({targets.result}, name{1}));
  end
  isProfile = find ([targets.curve] > 0);
  [~, order] = sort ([targets(isProfile).at]);
  at = [at, isProfile(order)];
end

function sayClosure (Case, folder, run)
  [before, n0, sd] = seriesMeans (Case, folder, 1);
  T = numel (sd);
  role = run.causes(:, 3);
  reference = find (strcmp (role, 'reference'), 1);
  for i = find (~strcmp (role, 'reference'))'
    [after, n] = seriesMeans (Case, folder, str2double (run.causes{i, 1}));
    variance = sd.^2 .* (1 ./ n0 + 1 ./ n);
    change = after - before;
    % the same sets of parameters without and with the cause
    each = run.both(run.line == i, :) - run.both(run.line == reference, :);
    each = each(all (isfinite (each), 2), :);
    was = sum (change.^2 ./ variance) - T;
    is = sum ((change - mean (each, 1)).^2 ./ variance) - T;
    printf ('series %s, %s (%s): %d sets, ', run.causes{i, 1:3}, rows (each));
    printf ('chi2 %.0f to %.0f of %d targets, closed %.0f %%\n', was + T, ...
            is + T, T, 100 * (1 - is / was));
  end
end

function step = stepOf (R4, R8, own, n4, n8)
  isProfile = 5:23;
  noise = own.^2 .* (1 ./ n4 + 1 ./ n8);
  each = max (mean ((R8 - R4).^2 - noise, 1), (0.25 * own).^2);
  each(isProfile) = mean (each(isProfile));
  step = sqrt (each);
end

function lines = rowsOf (key, model, value, half)
  names = [{'toe_angle_deg', 'top_angle_deg', 'length_cm', 'height_cm'}, ...
           arrayfun(@(x) sprintf ('profile_%.2f', x), 0.05:0.05:0.95, ...
                    'UniformOutput', false)];
  lines = cell (1, numel (names));
  for i = 1:numel (names)
    lines{i} = sprintf ('%d,%d,%s,%s,%.4g,%.4g,%.4g', key, model, names{i}, ...
                        value(i), value(i) - half(i), value(i) + half(i));
  end
end

function m = weighted (Z, w)
  m = w' * Z / sum (w);
end

% the sets of a series' causes with their weights
function [own, w] = setsOf (run, series, Z)
  role = run.causes(:, 3);
  mine = find (str2double (run.causes(:, 1)) == series & ...
               strcmp (role, 'cause'));
  if isempty (mine)
    mine = find (strcmp (role, 'reference'));
  end
  own = find (ismember (run.line, mine) & all (isfinite (Z), 2));
  w = str2double (run.causes(run.line(own), 4));
end

% what a series misses at both sizes: rows are the sets of its causes
function s = residuals (Case, folder, series, run)
  is8 = [Case.targets.model] == 1;
  q8 = quantities (Case.targets(is8));
  q4 = quantities (Case.targets(~is8));
  pick = @(v) {v(:, is8)(:, q8), v(:, ~is8)(:, q4)};
  [y, n, sd] = seriesMeans (Case, folder, series);
  y = pick (y);
  n = pick (n);
  sim = pick (run.both);
  own = pick (sd);
  [at, w] = setsOf (run, series, [sim{:}, run.Z{:}]);
  s = struct ('R8', y{1} - sim{1}(at, :), 'R4', y{2} - sim{2}(at, :), ...
              'n8', n{1}, 'n4', n{2}, 'at', at, 'w', w, 'own', own{1});
end

function lines = predictOne (s, series, mm, Z, run, step)
  weight8 = min (log2 (mm / 4), 1);
  walk = max (log2 (mm / 8), weight8 * (1 - weight8));
  carried = Z(s.at, :) + weight8 * s.R8 + (1 - weight8) * s.R4;
  best = weighted (carried, s.w);
  variance = weighted ((carried - best).^2, s.w) + walk * step.^2 + ...
             s.own.^2 .* (1 / 2 + weight8^2 ./ s.n8 + ...
                          (1 - weight8)^2 ./ s.n4);
  sd = sqrt (variance);
  half = @(z) max (1.645 * sd, abs (best - z) + 1.2816 * sd);
  number = str2double (run.causes(:, 1));
  role = run.causes(:, 3);
  lines = {};
  for i = find (strcmp (role, 'reference') | ...
                (number == series & strcmp (role, 'cause')))'
    z = mean (Z(run.line == i & all (isfinite (Z), 2), :), 1);
    lines = [lines, rowsOf([series, mm], run.causes{i, 2}, z, half (z))];
  end
  lines = [lines, rowsOf([series, mm], 'best', best, 1.645 * sd)];
  printf ('series %d, %d mm: half width of best %s\n', series, mm, ...
          sprintf ('%.3g ', 1.645 * sd(1:5)));
end

function result = predictCase (root, folder)
  useLiggghts (root);
  addpath (folder);
  Case = withEffects (loadCase (root, folder));
  part = Case;
  part.models = Case.models(1);
  part.targets = Case.targets([Case.targets.model] == 1);
  [~, run.causes] = readCsvTable (fullfile (folder, 'sealedCauses.csv'));
  [~, cells] = readCsvTable (fullfile (folder, 'predictionSets.csv'));
  sets = str2double (cells);
  run.line = sets(:, 1);
  sets = sets(:, 2:end);
  file = @(tail) fullfile (folder, ['predictionRuns', tail, '.csv']);
  run.both = resultsOf (file (''), Case, sets);
  sayClosure (Case, folder, run);
  q = quantities (part.targets);
  run.Z = {resultsOf(file ('6'), part, sets)(:, q), ...
           resultsOf(file ('10'), part, sets)(:, q)};
  for k = 1:4
    s(k) = residuals (Case, folder, k, run);
    m8(k, :) = weighted (s(k).R8, s(k).w);
    m4(k, :) = weighted (s(k).R4, s(k).w);
  end
  step = stepOf (m4, m8, s(1).own, vertcat (s.n4), vertcat (s.n8));
  printf ('step for a factor of two: %s\n', sprintf ('%.3g ', step(1:5)));
  lines = {'series,size_mm,model,quantity,value,lo90,hi90'};
  for k = 1:4
    lines = [lines, predictOne(s(k), k, 6, run.Z{1}, run, step), ...
             predictOne(s(k), k, 10, run.Z{2}, run, step)];
  end
  writeAtomic (fullfile (folder, 'prediction.csv'), ...
               sprintf ("%s\n", lines{:}));
  result.exitStatus = 0;
end

here = fileparts (mfilename ('fullpath'));
root = fileparts (fileparts (here));
addpath (fullfile (root, 'infrastructure'));
startMain (@predictCase, root);

% SPDX-License-Identifier: GPL-3.0-only
