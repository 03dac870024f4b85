% PREDICTSURFACES  Predicts the free surface at 10 and 30 rpm, by DEM.
%
% CALL: octave-cli predictSurfaces.m [NEW]
%
% NEW  DEM runs that may be made (40); 0: only those that are in the store
%
% Reads the calibrated sets, without and with the effect of the diagnosis, from
% predictionSets.csv: a row is a set, the columns are model (null, or the name
% of the effect, or best where none is named), packing (1, 2, ... of the
% calibrated set; 0: one of the sample of sets that fit), parameters and
% variables of effects. Runs each at 10 and 30 rpm. Writes prediction.csv.
%
% z is the mean over the packings of the calibrated set. Variance of the
% interval: that of the sample of sets about its mean (parameters and packing),
% the systematic error of the measurement (0.71 mm), and what the model misses
% by at 15 and 45 rpm beyond that error (missedSlow, missedFast: rms in mm of
% predictionMiss.csv), the mean of the two squares. Nothing is fitted to any
% measurement at 10 or 30 rpm.
%
% See also: DEcalioc, diagnoseGap, measureBench

1;

function Case = otherSpeeds (root, folder, nNew)
  Case = withEffects (loadCase (root, folder));
  Case.modelVars.speedSlow = 10;
  Case.modelVars.speedFast = 30;
  Case.store = fullfile (folder, 'results', 'prediction');
  Case.options.maxNewRuns = nNew;
  [~, ~] = mkdir (Case.store);
end

% Columns of the table by their names, missing ones at a default.
function M = columnsOf (header, cells, names, default)
  M = repmat (default, rows (cells), 1);
  for j = 1:numel (names)
    at = strcmp (header, names{j});
    if any (at)
      M(:, j) = str2double (cells(:, at));
    end
  end
end

% Mean and half width of the 90 % interval of one model.
function [z, half] = predictOne (Z, packing, miss)
  z = mean (Z(packing > 0 & all (isfinite (Z), 2), :), 1);
  spread = var (Z(packing == 0 & all (isfinite (Z), 2), :), 0, 1);
  excess = mean (max (miss.^2 - 0.71^2, 0));
  half = 1.645 * sqrt (spread + 0.71^2 + excess);
end

function lines = rowsOf (model, z, half, Case)
  lines = {};
  rpm = [10, 30];
  for t = 1:numel (z)
    isFast = strcmp (Case.targets(t).series, 'surfaceFast');
    lines{end + 1} = sprintf ('%d,%s,%d,%.2f,%.2f,%.2f', rpm(1 + isFast), ...
                              model, Case.targets(t).at, z(t), ...
                              z(t) - half(t), z(t) + half(t));
  end
end

function result = predictCase (root, folder)
  startToolbox (root, folder);
  useLiggghts (root);
  nNew = 40;
  if ~isempty (argv ()) && isfinite (str2double (argv (){end}))
    nNew = str2double (argv (){end});
  end
  Case = otherSpeeds (root, folder, nNew);
  [header, cells] = readCsvTable (fullfile (folder, 'predictionSets.csv'));
  [~, missed] = readCsvTable (fullfile (folder, 'predictionMiss.csv'));
  X = columnsOf (header, cells, Case.names, NaN (size (Case.names)));
  E = columnsOf (header, cells, Case.effectVars, neutralEffects (Case));
  packing = str2double (cells(:, strcmp (header, 'packing')));
  evaluate = newEvaluate (Case, newLedger (), @(text) disp (text));
  Z = evaluate (X, max (packing, 1), 'gap', E);
  own = cells(:, strcmp (header, 'model'));
  lines = {'rpm,model,x_mm,z_mm,lo90_mm,hi90_mm'};
  for name = unique (own, 'stable')'
    of = strcmp (own, name{1});
    row = strcmp (missed(:, 1), name{1});
    miss = str2double (missed(row, 2:3));
    [z, half] = predictOne (Z(of, :), packing(of), miss);
    lines = [lines, rowsOf(name{1}, z, half, Case)];
    printf ('%s: %d of %d runs\n', name{1}, ...
            sum (all (isfinite (Z(of, :)), 2)), sum (of));
  end
  writeAtomic (fullfile (folder, 'prediction.csv'), ...
               sprintf ('%s\n', lines{:}));
  result.exitStatus = 2 * any (isna (Z(:)));
end

here = fileparts (mfilename ('fullpath'));
root = fileparts (fileparts (here));
addpath (fullfile (root, 'infrastructure'), ...
         fullfile (root, 'infrastructure', 'case'));
startMain (@predictCase, root);
