% DIAGNOSECASE  Diagnoses the gap of a case: the method in short.
%
% CALL: DIAGNOSIS = diagnoseCase (ROOT, FOLDER)
%
%   ROOT       folder of the toolbox (text)
%   FOLDER     case folder, in which Octave works (text)
%   DIAGNOSIS  struct, see diagnoseMatrices, with the fields level, ledger and
%              exitStatus
%
% The main script diagnoseGap carries it out.
%
% See also: diagnoseGap, startMain, diagnoseMatrices

function diagnosis = diagnoseCase (root, folder)
  say = @(text) sayLine (text, fullfile (folder, 'Octave_logfile.txt'));
  lock = lockCase (folder);
  % the program belongs to the key of a run, also where none is made
  useLiggghts (root);
  whole = withEffects (loadCase (root, folder));
  needCandidates (whole);
  Case = withoutLevels (whole);
  ledger = newLedger ();
  evaluate = newEvaluate (Case, ledger, say);

  % the runs that there are
  [data, count] = gatherRuns (Case);
  [use, leftOut] = thinRuns (data, newProblem (Case), 1000);
  data = keepRows (data, use);
  [given, notes] = gapProblemOf (Case);
  notes = [notes(:)', {leftOut}(~isempty (leftOut)), unexpressedEffects(Case)];
  [~, foreseen] = gapBudget (Case, ledger, given, count.seconds);
  sayGapCase (Case, data, count, [notes, foreseen], say);
  data = completePlan (data, Case, evaluate, say);

  % where, which, how far, next test
  [part, own] = livingPart (Case, data, ledger);
  options = gapBudget (part, ledger, given, count.seconds);
  evaluate = newEvaluate (part, ledger, say);
  further = @(X, E, replicate, stage) ...
    inColumns (evaluate (X, replicate, stage, E), own);
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
  gap = readJsonFile (fullfile (folder, 'gap', 'gap.json'));
  writeGapHead (gap, Case);
  sayDiagnosis (diagnosis, Case, say);
  reportPage (Case, say);
  diagnosis.exitStatus = 2 * strcmp (diagnosis.which.verdict, 'surrogate');
end

% The case without the models that gave no result, which enterRuns leaves out;
% OWN, 1 x T logical: the targets of the others.
function [part, own] = livingPart (Case, data, ledger)
  model = [Case.targets.model];
  isAlive = ismember (1:numel (Case.models), ...
                      model(any (isfinite (data.Z), 1)));
  own = isAlive(model);
  number = cumsum (isAlive);
  part = Case;
  part.models = ledger('models')(isAlive);
  part.targets = Case.targets(own);
  for t = 1:sum (own)
    part.targets(t).model = number(part.targets(t).model);
  end
end

function Z = inColumns (found, own)
  Z = NaN (rows (found), numel (own));
  Z(:, own) = found;
end
