% DIAGNOSEGAP  Finds where a calibrated model misses and why: main script.
%
% CALL: octave-cli diagnoseGap.m    in a shell; or at the prompt: diagnoseGap
%
% For the case of the current folder (loadInput.m, loadEffects.m), after or
% without DEcalioc: WHERE the measurements are missed, WHICH unmodelled effect
% causes it, HOW FAR the gap shrinks once it is modelled, and the NEXT TEST.
% Finished runs are taken from the run store and from runs.csv; further ones
% are made within Input.maxNewRuns. Started again, it goes on where it stopped.
%
% Writes gap/gap.json and gap/*.csv. In a shell the exit status is 0 with a
% verdict, 2 where the surrogates allow none, 1 where it could not be done.
%
% See also: DEcalioc, loadEffects, diagnoseMatrices

1;

function diagnosis = diagnoseCase (root, folder)
  startToolbox (root, folder);
  say = @(text) sayLine (text, fullfile (folder, 'Octave_logfile.txt'));
  lock = lockCase (folder);
  % the program belongs to the key of a run, also where none is made
  useLiggghts (root);
  whole = withEffects (loadCase (root, folder));
  Case = withoutLevels (whole);
  ledger = newLedger ();
  evaluate = newEvaluate (Case, ledger, say);

  % the runs that there are
  [data, count] = gatherRuns (Case);
  [given, notes] = gapProblemOf (Case);
  notes = [notes(:)', unexpressedEffects(Case)];
  [~, foreseen] = gapBudget (Case, ledger, given, count.seconds);
  sayGapCase (Case, data, count, [notes, foreseen], say);
  data = completePlan (data, Case, evaluate, say);

  % where, which, how far, next test
  options = gapBudget (Case, ledger, given, count.seconds);
  further = @(X, E, replicate, stage) evaluate (X, replicate, stage, E);
  if options.maxNewRuns < 1
    further = [];
  end
  diagnosis = diagnoseMatrices (given, data, options, further);
  diagnosis.level = finerVerdict (whole, given, options, diagnosis);
  diagnosis.ledger = struct ('new', ledger('new'), ...
                             'reused', ledger('reused'), ...
                             'failed', ledger('failed'), ...
                             'coreSeconds', ledger('coreSeconds'));

  % what remains
  diagnosis.verdict = writeGapJson (diagnosis, Case);
  writeGapTables (diagnosis, Case);
  sayDiagnosis (diagnosis, Case, say);
  reportPage (Case, say);
  diagnosis.exitStatus = 2 * strcmp (diagnosis.which.verdict, 'surrogate');
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
diagnosis = startMain (@diagnoseCase, root);
