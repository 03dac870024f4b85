% DECALIOC  Calibrates the parameters of DEM models: main script.
%
% CALL: octave-cli DEcalioc.m      in a shell; or at the prompt: DEcalioc
%
% Calibrates the case of the current folder: its loadInput.m and DEMmodels/
% are looked for there first, then beside this script. What was run before is
% found again, so a calibration that was interrupted goes on where it stopped:
% octave-cli DEcalioc.m afresh moves it aside and starts anew.
%
% In a shell the exit status is 0 where all targets are met, 2 where the
% calibration finished without meeting them, 1 where it could not be done.
% At the prompt the result is left in the variable calibration.
%
% See also: loadInput, costFunction, diagnoseGap

1;

function calibration = calibrateCase (root, folder)
  startToolbox (root, folder);
  useLiggghts (root);
  say = @(text) sayLine (text, fullfile (folder, 'Octave_logfile.txt'));

  % input
  lock = lockCase (folder);
  if any (strcmp (argv (), 'afresh'))
    moveAside (folder);
  end
  Case = withLevels (loadCase (root, folder));
  restore = seedRandom (Case.options.seed);
  problem = newProblem (Case, @costFunction);
  ledger = newLedger ();
  evaluate = newEvaluate (Case, ledger, say);
  reportCase (Case, say);

  % experimental plan and DEM simulation
  data = importExisting (Case, say);
  [plan, levels] = newPlan (data, Case);
  data = runPlan (plan, data, Case, evaluate, say, levels);
  problem = withinBudget (problem, ledger, Case);

  % Kriging models
  [~, ~, surrogates] = createKrigingModels (data, problem);
  reportSurrogateFit (surrogates, data, problem, say);

  % optimisation on the Kriging models
  [found, history] = calibrateOnKriging (surrogates, problem);
  reportIterations (found, history, Case, say);

  % optimisation on the DEM models
  state = newState (data, surrogates, found);
  reportPage (Case, say, state);
  state = improveByInfill (state, problem, evaluate, say);
  reportPage (Case, say, state);
  state = calibrateOnDEM (state, problem, evaluate, say);

  calibration = newCalibration (state, problem, Case, ledger);
  calibration.verdict = writeCalibrationJson (calibration, Case);
  reportCalibration (calibration, Case, say);
  reportPage (Case, say);
end

root = fileparts (mfilename ('fullpath'));
if any (root == pathsep ())
  error ('DEcalioc:startToolbox:badFolder', ...
         ['the folder of the toolbox, %s, must have a path without a ' ...
          'colon, which parts the folders of the path of Octave. Rename ' ...
          'it.'], root);
end
addpath (fullfile (root, 'infrastructure'), ...
         fullfile (root, 'infrastructure', 'case'));
calibration = startMain (@calibrateCase, root);
