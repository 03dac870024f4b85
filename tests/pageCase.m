% PAGECASE  Makes the folder of a finished calibration, without DEM.
%
% CALL: CASE = pageCase (FOLDER)
%
%   FOLDER  folder to be made (text)
%   CASE    see newCase: the stand-in case of two formula models with the
%           parameters a and b; its last target is held out
%
% Three of its runs are in the store; one of them fails. The calibration works
% on formulas with a scatter of 0.3 %.
%
% See also: standInCase, pageGapCase

function Case = pageCase (folder)
  raw = standInCase (folder);
  raw.optim.targetVal = {[7, 12], 1};
  raw.optim.targetName = {{'sum (N)', 'product <b> & c'}, {'difference'}};
  raw.optim.role = {{'calibrate', 'calibrate'}, {'holdout'}};
  Case = newCase (raw);
  evaluateDEM ([4, 3; 6, 2], Case);
  script = fullfile (folder, 'DEMmodels', 'Second', 'runscript');
  kept = fileread (script);
  writeAtomic (script, "echo 'ERROR: <grains> lost'; exit 3\n");
  evaluateDEM ([8, 1], Case);
  writeAtomic (script, kept);
  rand ('twister', 1);
  randn ('twister', 1);
  problem = newProblem (Case, []);
  formulas = @(P, E, r) [P(:, 1) + P(:, 2), P(:, 1) .* P(:, 2), ...
                         P(:, 1) - P(:, 2)] .* ...
                        (1 + 0.003 * randn (rows (P), 3));
  X = double (stk_sampling_maximinlhs (10, 2, Case.limits, 50));
  writeMatrix (fullfile (folder, 'ExperimentalPlan_DoE.csv'), X);
  data = addRows (newData (2, 3), X, formulas (X, [], 1), ones (10, 1), 'plan');
  surrogates = fitSurrogates (data, problem);
  saveSurrogates (surrogates, fullfile (folder, 'KrigingFuns'));
  state = newState (data, surrogates, calibrateOnKriging (surrogates, ...
                                                          problem));
  state.evaluate = newEvaluate (formulas);
  state = improveByInfill (state, problem, @(text) []);
  state = calibrateOnDEM (state, problem, @(text) []);
  c = newCalibration (state, problem, Case);
  writeCalibrationJson (c, Case);
end

% SPDX-License-Identifier: GPL-3.0-only
