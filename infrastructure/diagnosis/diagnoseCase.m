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
% Errors: DEcalioc:needCandidates:missingField, DEcalioc:refuseCost:costAlone
%
% See also: diagnoseGap, startMain, diagnoseMatrices

function diagnosis = diagnoseCase (root, folder)
  say = newSay (fullfile (folder, 'Octave_logfile.txt'));
  lock = lockCase (folder);
  % the program belongs to the key of a run, also where none is made
  useLiggghts (root);
  Case = withEffects (loadCase (root, folder));
  refuseCost (Case);
  [Case, idle] = withoutIdle (Case);
  problem = withEarlier (newProblem (Case), Case);
  many = max (numel (Case.conditions), 1);
  [asked, assumed] = arrayfun (@(c) newProblem (Case, [], c), 1:many, ...
                               'UniformOutput', false);
  options = gapOptions (struct ('seed', Case.options.seed));
  [state, plain] = runsThere (Case, problem, options, {assumed{1}, idle}, say);
  state = completePlan (state, problem, Case, say, options);

  problems = cell (2, many);
  for c = 1:many
    [problems{:, c}] = finerLevel (asked{c}, plain.surrogates, plain.data, problem);
  end
  [state, made] = exploreAll (Case, problems(1, :), state, options);

  if exist ('caseMeasurements', 'file') == 2        % a wing, see adviseMeasurements
    problems(1, :) = cellfun (@(given) setfield (given, 'tests', ...
                                                 @() caseMeasurements (Case, say)), ...
                              problems(1, :), 'UniformOutput', false);
  end

  % Holm: a rejected condition passes its alpha on
  studies = cellfun (@(given) studyOf (Case, given, state, options, many), problems(1, :), ...
                     'UniformOutput', false);
  options.explore = many == 1;
  [level, isChanged] = stepDown (cellfun (@(s) s.p, studies), options.significance, ...
                                 @(c, level) hasChanged (studies{c}, level));

  % where, which, how far, next test: last of the one that leads, for its files lie in
  % gap/ itself
  others = [];
  order = leadLast (isChanged);
  for c = order
    [given, finer] = problems{:, c};
    [share, own] = shareOf (Case, given, state, atLevel (options, level(c)), ...
                            many - numel (others));
    [diagnosis, further] = diagnoseMatrices (resumed (studies{c}, share, own));
    diagnosis.runs = addFields (diagnosis.runs, made(c));
    diagnosis.level = finer (diagnosis, share);
    state.budget = diagnosis.budget;
    diagnosis.others = compareConditions (diagnosis, others);
    % what remains
    [diagnosis, others] = reportDiagnosis (diagnosis, Case, share, say);
    if ~isempty (further)
      diagnosis = tryFurther (diagnosis, further, Case, share, say);
    end
    if many > 1
      putAside (fullfile (Case.folder, 'gap'), Case.conditions{c});
    end
  end
  reportPage (Case, say);
  diagnosis.exitStatus = 2 * strcmp (diagnosis.which.verdict, 'surrogate');
end

% The first condition that has changed leads; where none has, the first one.
function order = leadLast (isChanged)
  [~, lead] = max (isChanged);           % the first one where none has
  order = [setdiff(numel (isChanged):-1:1, lead, 'stable'), lead];
end

% The state of a diagnosis with the runs that there are; PLAIN (struct data,
% surrogates: of runs without an effect at all levels, where a case has levels).
% What is known of them, and NOTES (what was assumed of the problem, which effects
% are idle), are said.
function [state, plain] = runsThere (Case, problem, options, notes, say)
  [state.evaluate, state.budget] = newCaseEvaluate (Case, say);
  state.budget.models = measuredModels (Case);
  [data, count] = gatherRuns (Case);
  [data, levelled] = atLevels (data, Case, problem);
  [use, leftOut] = thinRuns (data, problem, 1000);
  data = keepRows (data, use);
  plain = struct ('data', levelled, 'surrogates', []);
  if ~isempty (problem.coarse)
    plain.data = keepRows (levelled, thinRuns (levelled, problem, 1000));
    plain.surrogates = fitSurrogates (plain.data, problem);
  end
  [assumed, idle] = notes{:};
  notes = [assumed(:)', {Case.scatterNotes.text}, {leftOut}(~isempty (leftOut)), ...
           idle, unexpressedEffects(Case), unmeasured(Case, state.budget.models)];
  left = floor (state.budget.left / sum (state.budget.models));
  [~, foreseen] = foreseeSets (problem.effects, left, options, ...
                               sum (count.seconds(state.budget.models)));
  sayGapCase (Case, data, count, [notes, foreseen], say);
  state.data = data;
end

function notes = unmeasured (Case, isMeasured)
  notes = cellfun (@(name) [name, ' was not measured in the new state: no runs of it'], ...
                   {Case.models(~isMeasured).name}, 'UniformOutput', false);
end

% The verdict is said and kept by now: who does not want to wait may go.
function diagnosis = tryFurther (diagnosis, further, Case, options, say)
  reportPage (Case, say);
  most = min (options.testRuns, diagnosis.budget.left);
  cellfun (say, {'', sentence('next.trying', struct ('runs', most))});
  [level, others] = deal (diagnosis.level, diagnosis.others);
  diagnosis = further ();
  [diagnosis.level, diagnosis.others] = deal (level, others);
  diagnosis = reportDiagnosis (diagnosis, Case, options, say, true);
end

% Of several conditions all runs are there by now (exploreAll).
function study = studyOf (Case, given, state, options, many)
  [share, own] = shareOf (Case, given, state, options, many);
  share.explore = many == 1;
  study = studyGap (given, state.data, share, own, options.significance ./ (1:many));
end

function options = atLevel (options, level)
  options.significance = level;
end

% Where surrogates are to blame nothing is known to have changed.
function is = hasChanged (study, level)
  is = study.p < level;
  if is
    study.hypotheses.options = atLevel (study.hypotheses.options, level);
    side = sideSignals (study.problem, study.emulator, study.fits.calibrated.Q(1, :), ...
                        study.hypotheses.options);
    is = ~strcmp (judgeStudy (study, side).kind, 'surrogate');
  end
end

% At the level of OPTIONS; one of several conditions with what STATE has left to run.
function study = resumed (study, options, state)
  study.hypotheses.options = atLevel (study.hypotheses.options, options.significance);
  if ~options.explore
    [study.state.evaluate, study.state.budget] = deal (state.evaluate, state.budget);
    study.state.budget.sets = options.maxNewRuns;
  end
end

function refuseCost (Case)
  if Case.isCost
    error ('DEcalioc:refuseCost:costAlone', ...
           ['diagnose needs the results that miss, got one cost (optim.role ' ...
            '''smallest''), which does not say which of them does. Put them into ' ...
            'runs.csv, a column each, and their measured values into loadInput.m.']);
  end
end

% All conditions have their runs before one is judged: all by the same runs, in
% whatever order, and as a second start judges them. MADE (1 x many struct spent,
% failed) are those of each; a single one makes its own as it is judged.
function [state, made] = exploreAll (Case, problems, state, options)
  many = numel (problems);
  made = repmat (struct ('spent', 0, 'failed', 0), 1, many);
  if many == 1
    return
  end
  for c = many:-1:1
    [share, own] = shareOf (Case, problems{c}, state, options, c);
    explored = exploreGap (problems{c}, state.data, share, own);
    made(c) = runsMade (explored.state, explored.known);
    [state.data, state.budget] = deal (explored.data, explored.state.budget);
  end
end

function runs = addFields (runs, made)
  for name = fieldnames (made)'
    runs.(name{1}) = runs.(name{1}) + made.(name{1});
  end
end

% With one of PARTS equal parts of what may still be run. Models that gave no result
% are left out, as enterRuns does, and of a change those that GIVEN has no reading of.
function [options, state] = shareOf (Case, given, state, options, parts)
  isThere = any (isfinite (state.data.Z), 1);
  if ~isempty (given.reference)
    isThere = isThere & ismember (given.bench, given.bench(isfinite (given.value)));
  end
  state.budget.models = ismember (1:numel (Case.models), given.bench(isThere));
  left = floor (state.budget.left / sum (state.budget.models));
  options.maxNewRuns = min (foreseeSets (given.effects, left, options), ...
                            floor (left / parts));
  if options.maxNewRuns < 1
    state.evaluate = [];
  end
end

% The effects of each run apart from how coarse it is for each target (level, n
% x T, see unitLevel); plain runs with the values of the levels.
function [data, levelled] = atLevels (data, Case, problem)
  v = numel (Case.coarse);
  isPlain = data.E(:, v + 1:end) == neutralEffects (Case)(v + 1:end);
  levelled = keepRows (data, all (isPlain, 2));
  levelled.E = levelled.E(:, 1:v);
  if v > 0
    data.level = unitLevel (problem.coarse, data.E(:, 1:v));
  end
  data.E = data.E(:, v + 1:end);
end

% Each condition has its files in a folder of its own, the leading one in gap/, too.
function putAside (folder, name)
  [~, ~] = mkdir (folder, name);
  for file = {'gap.json', 'calibrated.head'}
    [~, ~] = unlink (fullfile (folder, name, file{1}));
    if isfile (fullfile (folder, file{1}))
      copyfile (fullfile (folder, file{1}), fullfile (folder, name, file{1}));
    end
  end
end

% An effect of the laboratory that can act on no result is no candidate
% (speedError without a curve over speed): NOTE says so.
function [Case, note] = withoutIdle (Case)
  [note, names] = deal ({}, '');
  if ~isempty (Case.effects)
    [~, nowhere] = unexpressedEffects (Case);
    isIdle = nowhere & [Case.effects.laboratory];
    names = strjoin ({Case.effects(isIdle).name}, ', ');
    note = repmat ({['no result can show ', names, ', which is left out']}, ...
                   1, any (isIdle));
    Case.effects = Case.effects(~isIdle);
  end
  what = [repmat('an empty list', 1, isempty (names)), ...
          repmat([names, ', which no result can show'], 1, ~isempty (names))];
  needCandidates (Case, what);
end

% Without candidates there is nothing to choose from: said before any run, with
% a list of what the models of the case can express, to be copied. WHAT is what
% the list is.
function needCandidates (Case, what)
  if ~isempty (Case.effects)
    return
  end
  names = expressibleEffects (Case);
  if isempty (names)
    error ('DEcalioc:needCandidates:missingField', ...
           ['loadEffects.m must list what the model may lack, got %s. None of ' ...
            'the known causes can be expressed by this case: no model declares their ' ...
            'variables, and runs.csv has no such columns. Write one of your own ' ...
            '(docs/extend.md).'], what);
  end
  list = ["'", strjoin(names, "', '"), "'"];
  error ('DEcalioc:needCandidates:missingField', ...
         ['loadEffects.m must list what the model may lack, got %s. ' ...
          'This case can express these; copy the line to ' ...
          'loadEffects.m and strike out what cannot be (docs/effects.md):' ...
          '\n  effects = {%s};'], what, list);
end

%!test
%! % without candidates it stops before any run, and says what the model can do
%! raw = standInCase (tempname ());
%! writeLoadInput (raw.folder);
%! writeAtomic (fullfile (raw.folder, 'loadEffects.m'), ...
%!              "function effects = loadEffects ()\neffects = [];\nend\n");
%! head = fullfile (raw.folder, 'DEMmodels', 'First', 'data.head');
%! writeAtomic (head, [fileread(head), "variable cohesionPP equal 0\n", ...
%!                     "variable cohesionPW equal 0\n"]);
%! home = cd (raw.folder);
%! back = onCleanup (@() cd (home));
%! try
%!   diagnoseCase (fileparts (which ('DEcalioc')), raw.folder);
%! catch err
%!   assert (err.identifier, 'DEcalioc:needCandidates:missingField');
%! end
%! assert (! isempty (strfind (err.message, '''cohesion''')));
%! assert (isempty (strfind (err.message, 'speedError')));
%! assert (! isfolder (fullfile (raw.folder, 'optim')));
%! % nor with one that can act on no result
%! writeAtomic (fullfile (raw.folder, 'loadEffects.m'), ...
%!              "function e = loadEffects ()\ne = {'speedError'};\nend\n");
%! clear loadEffects;
%! try
%!   diagnoseCase (fileparts (which ('DEcalioc')), raw.folder);
%! catch err
%!   assert (err.identifier, 'DEcalioc:needCandidates:missingField');
%! end
%! assert (! isempty (strfind (err.message, 'got speedError, which no result')));

% SPDX-License-Identifier: GPL-3.0-only
