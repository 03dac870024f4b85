% CHECKCARRY  Checks the recipe of the prediction on drums that are simulated.
%
% CALL: octave-cli checkCarry.m [NEW]
%
% NEW  DEM runs that may be made (0)
%
% The drums have another law: the effects at full or half strength that runs.csv
% holds at the set nearest to the first one of predictionSets.csv (15 and 45
% rpm). Each is run at 10 and 30 rpm, too (lawRuns.csv). Then it counts as
% measured at 15 and 45 rpm, and the model without effects, with the sets of
% predictionRuns.csv, predicts it at 10 and 30 by carryResidual.m. The standard
% deviation of the weight is learned from the other drums. Printed per drum and
% speed: rms missed without and with the residual carried, mean half width of
% the 90 % interval, places held.
%
% See also: carryResidual, predictSurfaces, runPredictions

1;

function drums = drumsOf (Case, folder)
  data = gatherRuns (Case);
  [~, cells] = readCsvTable (fullfile (folder, 'predictionSets.csv'));
  first = str2double (cells(1, 2:end));
  neutral = neutralEffects (Case);
  isOther = any (data.E ~= neutral, 2) & all (isfinite (data.Z), 2);
  near = all (abs (data.X - first) < [0.02, 0.02, 0.02], 2);
  % a mantle so smooth that the bed slips is no drum of this kind
  slips = data.E(:, strcmp (Case.effectVars, 'wallFrictionFactor')) < 0.2;
  own = isOther & near & ~slips;
  drums = struct ('X', data.X(own, :), 'E', data.E(own, :), ...
                  'Z', data.Z(own, :));
end

function runLaws (Case, folder, drums, nNew)
  Case.modelVars.speedSlow = 10;
  Case.modelVars.speedFast = 30;
  Case.store = fullfile (folder, 'results', 'prediction');
  Case.options.maxNewRuns = nNew;
  Case.options.maxCPU = 1;
  [~, ~] = mkdir (fullfile (folder, 'results'));
  [~, ~] = mkdir (Case.store);
  Z = evaluateDEM (drums.X, Case, 1, 'gap', newProgress ('gap', @disp), ...
                   drums.E);
  there = all (isfinite (Z), 2);
  data = struct ('X', drums.X(there, :), 'Z', Z(there, :), ...
                 'E', drums.E(there, :), 'replicate', ones (sum (there), 1));
  exportRuns (fullfile (folder, 'lawRuns.csv'), Case, data);
end

% what the weight of 45 rpm would have to be less what it was, and the rest
function [off, w, moved] = weightOf (sim, M, R, truth)
  step = M{2} - M{1};
  w = sum (sum ((sim - M{1}) .* step)) / sumsq (step(:));
  change = mean (R{2} - R{1}, 1);
  missed = truth - mean (sim + (1 - w) * R{1} + w * R{2}, 1);
  off = sum (missed .* change) / sumsq (change);
  moved = norm (change) / sqrt (numel (change));
end

function table = checkAll (Case, folder, drums)
  surrogates = neutralSurrogates (Case, true (1, numel (Case.targets)));
  law = importRuns (fullfile (folder, 'lawRuns.csv'), Case);
  other = importRuns (fullfile (folder, 'predictionRuns.csv'), Case);
  [M, V] = predictSurrogate (surrogates, other.X);
  is = {strcmp({Case.targets.series}, 'surfaceSlow')};
  is{2} = ~is{1};
  noise = mean ([surrogates.noiseVar]);
  at.M = {M(:, is{1}), M(:, is{2})};
  spread = {mean(V(:, is{1})), mean(V(:, is{2}))};
  parts = zeros (0, 8);
  kept = {};
  for i = 1:rows (law.X)
    d = find (all (abs (drums.E - law.E(i, :)) < 1e-9, 2), 1);
    R = {drums.Z(d, is{1}) - at.M{1}, drums.Z(d, is{2}) - at.M{2}};
    for k = 1:2
      sim = other.Z(:, is{k});
      truth = law.Z(i, is{k});
      [off, w, moved] = weightOf (sim, at.M, R, truth);
      parts(end + 1, :) = [i, k, w, off, moved, d, 0, 0];
      known = (1 - w)^2 * spread{1} + w^2 * spread{2};
      kept{end + 1} = struct ('sim', sim, 'R', {R}, 'truth', truth, ...
                              'surrogate', known);
    end
  end
  table = zeros (0, 8);
  for j = 1:rows (parts)
    c = kept{j};
    others = parts(:, 1) ~= parts(j, 1);
    sdW = sqrt (sumsq (parts(others, 4) .* parts(others, 5)) / ...
                sumsq (parts(others, 5)));
    change = sqrt ((sdW * parts(j, 5))^2 + c.surrogate);
    w = parts(j, 3);
    [z, half] = carryResidual (c.sim, c.R, [1 - w, w], change, sqrt (noise));
    rms = @(v) norm (v) / sqrt (numel (v));
    table(j, :) = [parts(j, [1, 2]), w, parts(j, 4), ...
                   rms(c.truth - mean (c.sim, 1)), rms(c.truth - z), ...
                   mean(half), sum(abs (c.truth - z) <= half)];
    printf ('| %s | %d | %.2f | %.2f | %.2f | %.2f | %.1f | %.2f | %d |\n', ...
            sprintf ('%g ', drums.E(parts(j, 6), :)), 20 * parts(j, 2) - 10, ...
            w, parts(j, 4), parts(j, 5), table(j, 5:6), table(j, 7), ...
            table(j, 8));
  end
end

function result = checkDrums (root, folder)
  useLiggghts (root);
  nNew = 0;
  if ~isempty (argv ()) && isfinite (str2double (argv (){end}))
    nNew = str2double (argv (){end});
  end
  Case = withEffects (loadCase (root, folder));
  drums = drumsOf (Case, folder);
  if nNew > 0
    runLaws (Case, folder, drums, nNew);
  end
  printf ('| %s | rpm | W | off | moved | null | carried | half | held |\n', ...
          strjoin (Case.effectVars, ' '));
  table = checkAll (Case, folder, drums);
  printf (['%d drums: carried misses %.2f mm rms, without %.2f; half width ' ...
           '%.2f mm, %.1f times the rms missed; %.0f %% of places held\n'], ...
          rows (table) / 2, sqrt (mean (table(:, 6).^2)), ...
          sqrt (mean (table(:, 5).^2)), mean (table(:, 7)), ...
          mean (table(:, 7)) / sqrt (mean (table(:, 6).^2)), ...
          100 * mean (table(:, 8)) / 27);
  result.exitStatus = 0;
end

here = fileparts (mfilename ('fullpath'));
root = fileparts (fileparts (here));
addpath (fullfile (root, 'infrastructure'), here);
startMain (@checkDrums, root);

% SPDX-License-Identifier: GPL-3.0-only
