% PREDICTSURFACES  Predicts the measured free surface at 10 and 30 rpm.
%
% CALL: (in finer/) octave-cli ../predictSurfaces.m
%
% From runs.csv (15 and 45 rpm) and predictionRuns.csv (10 and 30 rpm,
% runPredictions.m) of the last level, without further runs. Writes
% ../prediction2.csv, rows of two models:
%   null  the calibrated model as it is: mean over the packings of its set
%   best  null plus what it misses: measured minus simulated at 15 and 45 rpm,
%         carried to the other speed (carryResidual) with each of the sets that
%         were run
%
% Weights of the two speeds: the residual is taken to go with the speed as the
% simulated surface goes, from 15 to 45 rpm by the parts W that a least squares
% line over x gives at 10 and 30 rpm. W counts as known to 0.19: so much it was
% off on 13 drums of other laws whose four speeds are known (checkCarry.m). A
% packing and 0.1 mm are what a measured surface has of its own.
%
% The interval of null is about its own z and so wide that it holds 90 % of what
% best says. Nothing is fitted to any measurement at 10 or 30 rpm.
%
% See also: drawPredictionSets, runPredictions, checkCarry, halfAbout

1;

function lines = rowsOf (rpm, model, x, z, half)
  lines = cell (1, numel (z));
  for i = 1:numel (z)
    lines{i} = sprintf ('%d,%s,%d,%.2f,%.2f,%.2f', rpm, model, x(i), z(i), ...
                        z(i) - half(i), z(i) + half(i));
  end
end

function [lines, w] = predictOne (rpm, sim, at, own, x)
  step = at.M{2} - at.M{1};
  w = sum (sum ((sim - at.M{1}) .* step)) / sumsq (step(:));
  moved = norm (mean (at.R{2} - at.R{1}, 1)) / sqrt (numel (x));
  [best, half] = carryResidual (sim, at.R, [1 - w, w], 0.19 * moved, at.sd);
  null = mean (sim(own, :), 1);
  wide = halfAbout (best - null, half / 1.645);
  lines = [rowsOf(rpm, 'null', x, null, wide), ...
           rowsOf(rpm, 'best', x, best, half)];
  printf (['%d rpm: W %.2f, residual changes by %.1f mm rms from 15 to ' ...
           '45 rpm; null and best differ by %.2f mm rms, half widths %.1f ' ...
           'and %.1f mm in the mean\n'], rpm, w, moved, ...
          norm (best - null) / sqrt (numel (x)), mean (wide), mean (half));
end

function result = predictCase (root, folder)
  useLiggghts (root);
  Case = withEffects (loadCase (root, folder));
  [surrogates, ~, data] = neutralSurrogates (Case, ...
                                             true (1, numel (Case.targets)));
  other = importRuns (fullfile (folder, 'predictionRuns.csv'), Case);
  y = [Case.targets.value];
  M = zeros (size (other.Z));
  for i = 1:rows (M)
    same = all (abs (data.X - other.X(i, :)) < 1e-6, 2);
    M(i, :) = mean (data.Z(same, :), 1);
  end
  at.sd = sqrt (mean ([surrogates.noiseVar]) + 0.1^2);
  series = {'surfaceSlow', 'surfaceFast'};
  rpm = [10, 30];
  for k = 1:2
    of = strcmp ({Case.targets.series}, series{k});
    at.M{k} = M(:, of);
    at.R{k} = y(of) - M(:, of);
    sim{k} = other.Z(:, of);
  end
  x = [Case.targets(of).at];
  own = all (abs (other.X - other.X(1, :)) < 1e-6, 2);
  lines = {'rpm,model,x_mm,z_mm,lo90_mm,hi90_mm'};
  for k = 1:2
    lines = [lines, predictOne(rpm(k), sim{k}, at, own, x)];
  end
  writeAtomic (fullfile (fileparts (folder), 'prediction2.csv'), ...
               sprintf ('%s\n', lines{:}));
  result.exitStatus = 0;
end

here = fileparts (mfilename ('fullpath'));
root = fileparts (fileparts (here));
addpath (fullfile (root, 'infrastructure'), here);
startMain (@predictCase, root);

% SPDX-License-Identifier: GPL-3.0-only
