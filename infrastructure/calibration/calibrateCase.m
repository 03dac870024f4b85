% CALIBRATECASE  Calibrates a case: the method in short, block by block.
%
% CALL: CALIBRATION = calibrateCase (ROOT, FOLDER)
%
%   ROOT         folder of the toolbox (text)
%   FOLDER       case folder, in which Octave works (text)
%   CALIBRATION  struct, see newCalibration
%
% The main script DEcalioc carries it out.
%
% See also: DEcalioc, startMain, newProblem

function calibration = calibrateCase (root, folder)
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
  reportCase (Case, say, problem);
  sayOldRuns (Case, say);

  % experimental plan and DEM simulation
  [data, rest] = importExisting (Case, problem, say);
  [plan, levels] = newPlan (data, Case);
  data = runPlan (plan, data, Case, evaluate, say, levels);
  problem = withinBudget (problem, ledger, Case);

  % Kriging models
  [~, ~, surrogates] = createKrigingModels (data, problem);
  reportSurrogateFit (surrogates, data, problem, say, rest);

  % optimisation on the Kriging models
  [found, history] = calibrateOnKriging (surrogates, problem);
  reportIterations (found, history, Case, say);

  % optimisation on the DEM models
  state = newState (data, surrogates, found);
  if strcmp (problem.options.method, 'robust')
    reportPage (Case, say, state);
    state = improveByInfill (state, problem, evaluate, say);
  end
  reportPage (Case, say, state);
  state = calibrateOnDEM (state, problem, evaluate, say);

  calibration = newCalibration (state, problem, Case, ledger);
  calibration.verdict = writeCalibrationJson (calibration, Case);
  reportCalibration (calibration, Case, say);
  reportPage (Case, say);
end
