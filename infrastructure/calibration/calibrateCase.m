% CALIBRATECASE  Calibrates a case: the method in short, block by block.
%
% CALL: CALIBRATION = calibrateCase (ROOT, FOLDER)
%
%   ROOT         folder of the toolbox (text)
%   FOLDER       case folder, in which Octave works (text)
%   CALIBRATION  struct, see newCalibration
%
% The main script DEcalioc carries it out. What is handed on here is the same in
% all functions of this folder: STATE (newState) with DATA (newData) and
% SURROGATES (fitSurrogates), PROBLEM (newProblem), CASE (newCase) and SAY, a
% handle that takes one line of text.

function calibration = calibrateCase (root, folder)
  useLiggghts (root);
  say = @(text) sayLine (text, fullfile (folder, 'Octave_logfile.txt'));

  % input
  lock = lockCase (folder);
  if any (strcmp (argv (), 'afresh'))
    moveAside (folder);
  end
  Case = loadCase (root, folder);
  restore = seedRandom (Case.options.seed);
  problem = newProblem (Case, @costFunction);
  reportCase (Case, say, problem);

  % experimental plan and DEM simulation
  [data, rest] = importExisting (Case, problem, say);
  state = newState (data);
  [state.evaluate, state.budget] = newEvaluate (Case, say);
  state = trustLibrary (state, problem, say);
  [plan, levels] = newPlan (state.data, Case);
  state = runPlan (state, problem, plan, levels, Case, say);

  % Kriging models
  [~, ~, state.surrogates] = createKrigingModels (state.data, problem);
  reportSurrogateFit (state.surrogates, state.data, problem, say, rest);

  % optimisation on the Kriging models
  [state.found, history] = calibrateOnKriging (state.surrogates, problem);
  reportIterations (state.found, history, Case, say);

  % optimisation on the DEM models
  if strcmp (problem.options.method, 'robust')
    reportPage (Case, say, state);
    state = improveByInfill (state, problem, say);
    state = runForIntervals (state, problem);
  end
  reportPage (Case, say, state);
  state = calibrateOnDEM (state, problem, say);

  calibration = newCalibration (state, problem, Case);
  calibration.verdict = writeCalibrationJson (calibration, Case);
  reportCalibration (calibration, Case, say);
  reportPage (Case, say);
end

%!test
%! % from the input to the files of the results
%! folder = tempname ();
%! standInCase (folder);
%! writeLoadInput (folder);
%! root = fileparts (which ('DEcalioc'));
%! home = cd (folder);
%! back = onCleanup (@() cd (home));
%! said = evalc ('c = calibrateCase (root, folder);');
%! assert (c.params, [4, 3], 0.05);
%! assert ([c.converged, c.exitStatus], [1, 0]);
%! assert (~isempty (strfind (said, 'Experimental plan')));
%! assert (isfile (fullfile (folder, 'results', 'calibration.json')));
