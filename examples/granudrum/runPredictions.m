% RUNPREDICTIONS  Runs the sets of predictionSets.csv at 10 and 30 rpm.
%
% CALL: octave-cli runPredictions.m [NEW]
%
% NEW  DEM runs that may be made (12); 0: only those that are in the store; if
%      there is none, predictionRuns.csv stays as it is
%
% A run turns the drum at 10, then at 30 rpm, otherwise as the model does.
% Writes predictionRuns.csv, with the columns of runs.csv: surfaceSlow is the
% surface at 10 rpm there, surfaceFast that at 30 rpm. All of it is simulated.
%
% See also: drawPredictionSets, predictSurfaces

1;

function result = runCase (root, folder)
  useLiggghts (root);
  nNew = 12;
  if ~isempty (argv ()) && isfinite (str2double (argv (){end}))
    nNew = str2double (argv (){end});
  end
  Case = withEffects (loadCase (root, folder));
  Case.modelVars.speedSlow = 10;
  Case.modelVars.speedFast = 30;
  Case.store = fullfile (folder, 'results', 'prediction');
  Case.options.maxNewRuns = nNew;
  [~, ~] = mkdir (fullfile (folder, 'results'));
  [~, ~] = mkdir (Case.store);
  [~, cells] = readCsvTable (fullfile (folder, 'predictionSets.csv'));
  table = str2double (cells);
  X = table(:, 2:end);
  replicate = max (table(:, 1), 1);
  Z = evaluateDEM (X, Case, replicate, 'gap', newProgress ('gap', @disp));
  there = all (isfinite (Z), 2);
  data = struct ('X', X(there, :), 'Z', Z(there, :), ...
                 'E', repmat (neutralEffects (Case), sum (there), 1), ...
                 'replicate', replicate(there));
  n = sum (there);
  if n > 0
    exportRuns (fullfile (folder, 'predictionRuns.csv'), Case, data);
  end
  printf ('%d of %d runs\n', n, rows (X));
  result.exitStatus = 2 * (n < rows (X));
end

here = fileparts (mfilename ('fullpath'));
root = fileparts (fileparts (here));
addpath (fullfile (root, 'infrastructure'));
startMain (@runCase, root);

% SPDX-License-Identifier: GPL-3.0-only
