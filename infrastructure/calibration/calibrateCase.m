% CALIBRATECASE  Calibrates a case: the method in short, block by block.
%
% CALL: CALIBRATION = calibrateCase (ROOT, FOLDER)
%
%   ROOT         folder of the toolbox (text)
%   FOLDER       case folder, in which Octave works (text)
%   CALIBRATION  struct, see newCalibration; of one cost alone see reportCost
%
% The main script DEcalioc carries it out. What is handed on here is the same in
% all functions of this folder: STATE (newState) with DATA (newData) and
% SURROGATES (fitSurrogates), PROBLEM (newProblem), CASE (newCase) and SAY, a
% handle that takes one line of text. Started with the word afresh it moves what
% earlier starts have left aside.
%
% Errors: DEcalioc:moveAside:cannotWrite

function calibration = calibrateCase (root, folder)
  useLiggghts (root);
  say = newSay (fullfile (folder, 'Octave_logfile.txt'));

  % input
  lock = lockCase (folder);
  if any (strcmp (argv (), 'afresh'))
    moveAside (folder, say);
  end
  Case = loadCase (root, folder);
  if Case.isCost
    calibration = reportCost (Case, say);
    return
  end
  restore = seedRandom (Case.options.seed);
  problem = withEarlier (newProblem (Case, ownCost ()), Case);
  reportCase (Case, say, problem);

  % experimental plan and DEM simulation
  [data, rest] = importExisting (Case, problem, say);
  state = newState (data);
  [state.evaluate, state.budget] = newCaseEvaluate (Case, say);
  state = trustLibrary (state, problem, say);
  [state, asked] = planToSet (state, problem, Case, say, rest);
  [state, text] = keepApart (state, problem);
  if ~isempty (text)
    say (text);
    [state, asked] = planToSet (state, problem, Case, say, rest);
  end

  calibration = newCalibration (state, asked, Case);
  calibration = reportCalibration (calibration, Case, say);
end

% From the plan to the set that is handed back: what the published program does,
% block by block. REST  runs that thinRuns has left out. PROBLEM  less what the runs
% too often lack (leaveUnjudged).
function [state, problem] = planToSet (state, problem, Case, say, rest)
  rest = keepRows (rest, ismember (rest.stage, state.data.stage));
  [plan, E] = newPlan (state.data, Case);
  state = runPlan (state, problem, plan, E, Case, say);

  % Kriging models
  known = soleSource (state);
  if isempty (known)
    [~, ~, state.surrogates] = createKrigingModels (state.data, problem);
  else
    [~, ~, state.surrogates] = createKrigingModels (known.surrogates);
  end
  state = repeatSuspects (state, problem, say);
  reportSurrogateFit (state.surrogates, state.data, problem, say, rest, Case);
  [state.final, state.unjudged] = deal ([], {});
  [state, problem] = leaveUnjudged (state, problem);
  isNew = true;
  while isNew
    state = searchSet (state, problem, Case, say);
    [state, problem, isNew] = leaveUnjudged (state, problem);
  end
end

% The other source of all runs, fitted and searched already, where none of this case
% has come to it: [] where there is none.
function other = soleSource (state)
  other = state.others;
  if ~(isscalar (other) && all (strcmp (state.data.stage, other.source)))
    other = [];
  end
end

% PROBLEM  of what is judged
function state = searchSet (state, problem, Case, say)
  % optimisation on the Kriging models
  known = soleSource (state);
  if isempty (known) || ~isempty (state.unjudged)
    [state.found, history] = calibrateOnKriging (state.surrogates, problem);
  else
    [state.found, history] = deal (known.search.found, known.search.history);
  end
  reportIterations (state.found, history, Case, say);
  state.found = stayAtRuns (state, problem);

  % optimisation on the DEM models
  reportPage (Case, say, state);
  if strcmp (problem.options.method, 'robust')
    before = rows (state.data.X);
    state = improveByInfill (state, problem, say);
    state = runForIntervals (state, problem);
    if rows (state.data.X) > before
      reportPage (Case, say, state);
    end
  end
  state = calibrateOnDEM (state, problem, say);
end

% Nothing is deleted: moved back, the folders count again.
function moveAside (folder, say)
  stamp = strftime ('-%Y-%m-%d-%H%M%S', localtime (time ()));
  for name = {'optim', 'results', 'KrigingFuns', 'gap'}
    old = fullfile (folder, name{1});
    if isfolder (old)
      if S_ISLNK (lstat (old).mode)
        say (sprintf (['  WARNING: %s was a link to %s, where all stays as it is; the new ' ...
                       'one is a folder of the case. For another disk make a link again ' ...
                       'before the start'], old, canonicalize_file_name (old)));
      end
      [err, why] = rename (old, [old, stamp]);
      if err ~= 0
        error ('DEcalioc:moveAside:cannotWrite', ...
               'moveAside: %s must be movable, got: %s', old, why);
      end
    end
  end
end

function reportCase (Case, say, problem)
  tell = @(varargin) say (sprintf (varargin{:}));
  tell ('DEcalioc  case %s', Case.folder);
  wanted = @(is) countText (numel (requirementsOf (Case.targets(is), 1:sum (is))), ...
                            'target');         % a curve is one
  for k = 1:numel (Case.models)
    m = Case.models(k);
    tell ('  model %s (%s), %s a run, %s', m.name, m.folder, ...
          countText (m.cpu, 'CPU'), wanted ([Case.targets.model] == k));
  end
  [~, binary] = system ('command -v liggghts || echo none found');
  tell ('  LIGGGHTS: %s', strtrim (binary));
  o = Case.options;
  tell ('  %s, %s, %s (%s), seed %d, method %s', ...
        countText (numel (Case.names), 'parameter'), ...
        wanted (true (size (Case.targets))), countText (o.maxCPU, 'CPU'), ...
        o.executor, o.seed, o.method);
  measured = measuredParams (Case);
  if ~isempty (measured)
    tell ('  measured parameters: %s', measured);
  end
  known = {'noise of a run', problem.earlierRuns > 0, 'scatter.csv'; ...
           'shape of results', ~cellfun(@isempty, problem.shape), 'form.csv'; ...
           'runs that end in another way', ...
           any(vertcat (problem.others.times) ~= 1, 1), 'form.csv'};
  for row = known(cellfun (@any, known(:, 2)), :)'
    tell ('  %s: %s with %s of the model', row{1}, ...
          countText (sum (row{2}), 'target begins', 'targets begin'), row{3});
  end
  n = problem.nExtra;
  if n > 0 && strcmp (problem.options.method, 'published')
    text = countText (n, 'row beyond the targets, it is fitted', ...
                      'rows beyond the targets, all are fitted');
    tell ('  costFunction: %s', text);
  elseif n > 0
    tell ('  costFunction returns %s than there are targets: they only choose', ...
          countText (n, 'more row', 'more rows'));
    say ('    among values that fit');
  end
  cellfun (@(text) say (['  WARNING: ', text]), Case.notes);
  used = sum (strcmp ({Case.targets.role}, 'calibrate'));
  if used < numel (Case.names)
    tell ('  WARNING: %s cannot fix %s: many sets will do, and one is chosen', ...
          countText (used, 'target'), countText (numel (Case.names), 'parameter'));
  end
  say ('');
end

% How far the surrogates can be trusted. Q2 is the share of the responses'
% variance that is predicted when each run is left out in turn: 1 perfect, 0 no
% better than the mean. With the runs that thinRuns has left out (REST) they are
% compared, too.
function reportSurrogateFit (surrogates, data, problem, say, rest, Case)
  tell = @(varargin) say (sprintf (varargin{:}));
  say ('');
  say ('Kriging models (each run left out in turn)');
  tell ('  %-28s %6s %9s   %s', 'result', 'Q2', 'noise (%)', ...
        'range of the runs, measured');
  [shown, nPoints] = shownTargets (Case);
  for t = shown
    s = surrogates(t);
    tell ('  %-28s %6.2f %9.2f   %.4g to %.4g, %.4g%s', problem.targetNames{t}, ...
          s.Q2, 100 * sqrt (s.noiseVar) / abs (mean (s.z)), min (s.z), ...
          max (s.z), problem.value(t), ...
          repmat (' outside', 1, problem.value(t) < min (s.z) | problem.value(t) > max (s.z)));
  end
  if numel (shown) < numel (surrogates)
    tell ('  (of %d points on curves three each)', nPoints);
  end
  if rows (data.X) > 2000                % see fitSurrogates
    tell (['  WARNING: of %d runs 2000 are fitted, the nearest to ' ...
           'the targets and others'], rows (data.X));
  end
  if rows (rest.X) > 0
    sayLoss (surrogates, rest, problem, tell);
  end
end

function sayLoss (surrogates, rest, problem, tell)
  share = NaN (2, numel (surrogates));
  for t = 1:numel (surrogates)
    s = surrogates(t);
    P = rest.X;
    if ~isempty (s.extra)
      P(:, end + 1) = unitLevel (problem.coarse, rest.E, t);
    end
    miss = rest.Z(:, t) - predictSurrogate (s, P);
    rms = sqrt ([mean(miss(isfinite (miss)).^2); s.noiseVar]);
    share(:, t) = 100 * rms / (max (s.z) - min (s.z));
  end
  [most, t] = max (share(1, :));
  if ~isnan (most)
    tell (['  The %s off the surrogates by %.2g %% of the range at most ' ...
           '(rms, %s; the scatter of a run is %.2g %%)'], ...
          countText (rows (rest.X), 'run left out is', 'runs left out are'), ...
          most, problem.targetNames{t}, ...
          share(2, t));
  end
end

% The chance is that of the set it is said of, not that of the last iteration.
function reportIterations (found, history, Case, say)
  T = numel (Case.targets);
  tell = @(varargin) say (sprintf (varargin{:}));
  tol = [Case.targets.tol];
  tol(~[Case.targets.isAbsolute]) = NaN;
  say ('');
  say ('Optimisation on the Kriging models');
  for k = 1:numel (history)
    tell ('  iteration %d: residuals (%%)%s', history(k).iteration, ...
          residualText (history(k).residual(1:T), {Case.targets.name}, tol));
  end
  tell ('  starts: %d, these iterations from: %s', numel (found.starts), ...
        found.start);
  tell (['  %s: residuals (%%)%s; chance that all targets are met: ' ...
         '%.0f %%'], merge (strcmp (Case.options.method, 'published'), ...
                            'values that were found', 'likeliest values'), ...
        residualText (found.residual(1:T), {Case.targets.name}, tol), ...
        100 * found.probability);
  if ~isempty (givenField (found, 'preference', []))
    say (['  ', sentence('preference.used', found.preference)]);
  end
  if ~isempty (found.conflict)
    tell ('  no parameter values within your limits meet together: %s', ...
          strjoin (found.conflict, ', '));
  end
  say ('');
  say ('Optimisation on the DEM models');
end

%!test
%! % from the input to the files of the results
%! folder = tempname ();
%! standInCase (folder);
%! writeLoadInput (folder, 'Input.numOfSam = 20;');
%! writeAtomic (fullfile (folder, 'costFunction.m'), ...
%!              ["function r = costFunction (p, f, Case)\n", ...
%!               "r = [f(p) ./ [7; 12; 1] - 1; 1];\nend\n"]);
%! root = fileparts (which ('DEcalioc'));
%! home = cd (folder);
%! back = onCleanup (@() cd (home));
%! said = evalc ('c = calibrateCase (root, folder);');
%! assert (c.params, [4, 3], 0.05);
%! assert ([c.converged, c.exitStatus], [1, 0]);
%! for words = {'costFunction returns 1 more row than there are targets', ...
%!              'Experimental plan: 20 samples', 'First_1 +1\.00', ...
%!              ['values: residuals \(%\).*; chance that ', ...
%!               'all targets are met: \d+ %']}
%!   assert (~isempty (regexp (said, words{1})), words{1});
%! end
%! assert (isfile (fullfile (folder, 'results', 'calibration.json')));

% SPDX-License-Identifier: GPL-3.0-only
