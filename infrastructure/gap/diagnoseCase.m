% DIAGNOSECASE  Diagnoses the gap of a case: the method in short.
%
% CALL: DIAGNOSIS = diagnoseCase (ROOT, FOLDER)
%
%   ROOT       folder of the toolbox (text)
%   FOLDER     case folder, in which Octave works (text)
%   DIAGNOSIS  struct, see diagnoseMatrices, with the fields level and
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
  Case = withEffects (loadCase (root, folder));
  needCandidates (Case);
  problem = newProblem (Case);
  [evaluate, budget] = newEvaluate (Case, say);

  % the runs that there are
  [data, count] = gatherRuns (Case);
  [data, levelled] = atLevels (data, Case, problem);
  [use, leftOut] = thinRuns (data, problem, 1000);
  data = keepRows (data, use);
  [given, notes] = gapProblemOf (Case, 1);
  surrogates = [];
  if ~isempty (problem.coarse)
    levelled = keepRows (levelled, thinRuns (levelled, problem, 1000));
    surrogates = fitSurrogates (levelled, problem);
  end
  notes = [notes(:)', {leftOut}(~isempty (leftOut)), unexpressedEffects(Case)];
  [~, foreseen] = gapBudget (Case, budget, given, count.seconds);
  sayGapCase (Case, data, count, [notes, foreseen], say);
  state = struct ('data', data, 'budget', budget, 'evaluate', evaluate);
  state = completeBenches (state, problem, Case, say);
  state = completePlan (state, problem, Case, say);
  state.seconds = count.seconds;

  % where, which, how far, next test: of the first condition last, for its files
  % lie in gap/ itself
  others = [];
  for c = max (numel (Case.conditions), 1):-1:1
    given = gapProblemOf (Case, c);
    if ~isempty (problem.coarse)
      given = levelCandidate (given, surrogates, levelled, problem);
    end
    diagnosis = diagnoseOne (Case, given, state, c, say);
    diagnosis.level = finerVerdict (surrogates, problem, given, ...
                                    gapOptions (struct ('seed', ...
                                                        Case.options.seed)), ...
                                    diagnosis);
    [state.data, state.budget] = deal (diagnosis.data, diagnosis.budget);
    diagnosis.others = compareConditions (diagnosis, others);
    others = diagnosis.others.conditions;

    % what remains
    diagnosis.nextFile = writeNextTest (diagnosis.next, Case);
    diagnosis.verdict = writeGapJson (diagnosis, Case);
    writeGapTables (diagnosis, Case);
    sayDiagnosis (diagnosis, Case, say);
    if c > 1
      putAside (fullfile (Case.folder, 'gap'), Case.conditions{c});
    end
  end
  reportPage (Case, say);
  diagnosis.exitStatus = 2 * strcmp (diagnosis.which.verdict, 'surrogate');
end

% With one of SHARES equal parts of what may still be run.
function diagnosis = diagnoseOne (Case, given, state, shares, say)
  [part, state, own] = livingPart (Case, state);
  options = gapBudget (part, state.budget, given, state.seconds);
  given.tests = @() caseTests (Case, say);
  evaluate = newEvaluate (part, say);
  left = state.budget.left / state.budget.perSet;
  options.maxNewRuns = min (options.maxNewRuns, floor (left / shares));
  if options.maxNewRuns > 0
    state.evaluate = @(varargin) inColumns (evaluate, own, varargin{:});
  else
    state.evaluate = [];
  end
  diagnosis = diagnoseMatrices (given, state.data, options, state);
end

% The effects of each run apart from how coarse it is for each target (level, n
% x T, see unitLevel); plain runs with the values of the levels.
function [data, levelled] = atLevels (data, Case, problem)
  v = numel (Case.coarse);
  isPlain = data.E(:, v + 1:end) == neutralEffects (Case)(v + 1:end);
  levelled = keepRows (data, all (isPlain, 2));
  levelled.E = levelled.E(:, 1:v);
  if v > 0
    for t = 1:columns (data.Z)
      data.level(:, t) = unitLevel (problem.coarse, data.E(:, 1:v), t);
    end
  end
  data.E = data.E(:, v + 1:end);
end

% The case without the models that gave no result, which enterRuns leaves out,
% and the budget of its runs; OWN, 1 x T logical: the targets of the others.
function [part, state, own] = livingPart (Case, state)
  model = [Case.targets.model];
  isAlive = ismember (1:numel (Case.models), ...
                      model(any (isfinite (state.data.Z), 1)));
  own = isAlive(model);
  number = cumsum (isAlive);
  part = Case;
  part.models = Case.models(isAlive);
  state.budget.perSet = sum (isAlive);
  state.budget.seconds = state.budget.seconds(isAlive);
  part.targets = Case.targets(own);
  for t = 1:sum (own)
    part.targets(t).model = number(part.targets(t).model);
  end
end

function [Z, budget] = inColumns (evaluate, own, varargin)
  [found, budget] = evaluate (varargin{:});
  Z = NaN (rows (found), numel (own));
  Z(:, own) = found;
end

function putAside (folder, name)
  [~, ~] = mkdir (folder, name);
  for file = [{'gap.json', 'calibrated.head'}, ...
              {dir(fullfile (folder, '*.csv')).name}]
    if isfile (fullfile (folder, file{1}))
      movefile (fullfile (folder, file{1}), fullfile (folder, name, file{1}));
    end
  end
end
