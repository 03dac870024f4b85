% SAYSTATUS  Says how far a calibration is.
%
% CALL: STATUS = sayStatus (ROOT, FOLDER, ARGS)
%
%   ROOT    folder of the toolbox (text)
%   FOLDER  case folder (text)
%   ARGS    cell of texts; no option is known
%   STATUS  0; 2 where the result is of an earlier input
%
% Writes nothing, so it can look on beside a running Octave.

function status = sayStatus (root, folder, args)
  commandOptions (args, struct ());
  [Case, note] = caseToRead (root, folder);
  if Case.isCost
    b = bestKnown (Case);
    printf ('case    %s\nstate   %s\n', folder, b.reason);
    status = 0;
    return
  end
  s = caseStatus (Case, ownCost ());
  printf ('case    %s\n', folder);
  printf ('state   %s\n', stateText (s));
  if strcmp (s.state, 'running')
    waits = readText (fullfile (folder, 'decalioc.waits'));
    printf ('%s', regexprep (waits, '^(.+)$', "waits   $1\n"));
  end
  taken = libraryLine (Case);
  sayRuns (s, isempty (taken));
  printf ('%s', note);
  printf ('%s', regexprep (taken, '^(.+)$', 'library $1\n'));
  for k = 1:numel (s.failures)
    printf ('        %s\n', s.failures{k});
  end
  if strcmp (s.state, 'finished') && isempty (jsonAt (s.verdict, {'cause'}))
    cellfun (@(text) printf ('diagnose %s\n', text), foreseenOf (Case));
  end
  isOpen = any (strcmp (s.state, {'running', 'unknown', 'stopped'}));
  if isOpen && s.left > 0
    printf ('left    %s\n', leftText (s));
  end
  if isempty (s.verdict)
    sayBest (s.best, Case);
  else
    sayResult (s, Case);
  end
  status = 2 * ~(isempty (s.verdict) || isempty (s.changed));
end

% What a diagnosis would cost; of a broken list of candidates it says so itself.
function lines = foreseenOf (Case)
  lines = cell (1, 0);
  try
    Case = withEffects (Case);
    lines = diagnosisCost (Case, foresee (Case, runsOfCase (Case)));
  end
end

function text = stateText (s)
  h = s.holder;
  switch s.state
    case 'running'
      text = sprintf ('running (process %d), stage: %s', h.pid, s.stage);
    case 'unknown'
      text = sprintf (['process %d on %s works in it, if it is still ' ...
                       'there; stage: %s'], h.pid, h.host, s.stage);
    case 'stopped'
      commands = {'run', 'diagnose'};
      text = sprintf ('stopped in the stage: %s. Go on with decalioc %s', ...
                      s.stage, commands{1 + strcmp(s.stage, 'gap')});
    case 'finished'
      text = 'finished; decalioc report shows the result';
      if ~isempty (s.verdict) && ~isempty (s.changed)
        text = sprintf ('finished, but since then changed: %s. %s', ...
                        strjoin (s.changed, ', '), s.verdict.action);
      end
    case 'tried'
      text = 'one set has been tried. Start with decalioc run';
    otherwise
      text = 'nothing has been run yet. Start with decalioc run';
  end
end

% ISASIDE  no run of an earlier input is a sample
function sayRuns (s, isAside)
  plan = sprintf ('%d of %s done', s.plan(1), countText (s.plan(2), 'run'));
  isFinished = strcmp (s.state, 'finished');
  if isFinished
    % what failed was run with another seed, which is another run
    plan = countText (s.plan(2), 'run');
  end
  if s.later > 0
    plan = sprintf ('%s; then %s of %s', plan, countText (s.later, 'run'), ...
                    countText (s.sets(1), 'set'));
  end
  if ~isFinished
    plan = sprintf ('%s; a start may add %s (a repeat counts)', plan, ...
                    countText (s.sets(2), 'set'));
  end
  printf ('plan    %s\n', plan);
  for k = 1:numel (s.models)
    m = s.models(k);
    printf ('runs    %-12s %d done, %d running, %d waiting, %d failed', ...
            m.name, m.done, m.running, m.waiting, m.failed);
    if ~isnan (m.seconds)
      printf ('; %s a run', inWords (m.seconds));
    end
    if ~isempty (m.elapsed)
      printf ('; the longest has run for %s', inWords (max (m.elapsed)));
    end
    if m.lost > 0
      printf ('; %d broken off, to be made again', m.lost);
    end
    if m.unread > 0 && ~strcmp (s.state, 'running')
      printf ('; %d to be read at the next start', m.unread);
    end
    if m.old > 0
      printf ('; %d of an earlier model or input%s', m.old, ...
              repmat (', left aside', 1, isAside));
    end
    printf ('\n');
  end
end

function text = leftText (s)
  bounds = {' at most', ' until the plan is done'};
  text = [inWords(s.left), bounds{1 + any(strcmp (s.stage, {'plan', ''}))}];
end

% What was found is the set of the result, not another one that came near.
function sayResult (s, Case)
  v = s.verdict;
  label = 'result  ';
  if ~isempty (v.change)
    printf ('%s%s\n', label, v.change);
    label = '        ';
  end
  printf ('%s%s. %s\n', label, v.word, v.sentence);
  if ~isempty (v.gap)
    printf ('        %s\n', v.gap);
  end
  sayVerdict (v, @(text) printf ('      %s\n', text));
  for j = 1:numel (s.set)
    printf ('        %-24s %.5g\n', Case.names{j}, s.set(j));
  end
end

function sayBest (best, Case)
  if isempty (best)
    printf ('best    no set has all results yet\n');
    return
  end
  words = {'not all targets met', 'all targets met'};
  printf ('best    %s; mean of %s\n', words{1 + best.isMet}, countText (best.runs, 'run'));
  for j = 1:numel (Case.names)
    printf ('        %-24s %.5g%s\n', Case.names{j}, best.params(j), ...
            atLimit (best.params(j), Case.limits(1:2, j)));
  end
  curves = curveSummary (Case, best.residual);
  for k = 1:numel (curves)
    printf ('        %-24s %s: %.2f of the tolerance\n', curves(k).name, ...
            countText (numel (curves(k).own), 'point'), curves(k).share);
  end
  isMeasured = isfinite ([Case.targets.value]);       % others are tests to come
  for t = setdiff (find (isMeasured), [curves.own])
    T = Case.targets(t);
    held = repmat (', held out', 1, strcmp (T.role, 'holdout'));
    values = {'%+.1f %% (tolerance %.3g)', 100 * [best.residual(t), T.tol]};
    if T.isAbsolute
      values = {'%+.3g (tolerance %.3g)', [best.residual(t), T.tol] / T.shown.factor};
    end
    measured = strtrim (sprintf ('%.5g %s', T.value / T.shown.factor, T.shown.unit));
    printf (['        %-24s %.5g, measured %s: ', values{1}, '%s\n'], T.name, ...
            best.results(t) / T.shown.factor, measured, values{2}, held);
  end
end

% As near as a result is said to be at a limit, see newProblem (options.atLimit).
function text = atLimit (value, limits)
  words = {'', '  at its lower limit', '  at its upper limit'};
  [gap, k] = min (abs (value - limits) / diff (limits));
  text = words{1 + k * (gap < 0.005)};
end

%!test
%! % nothing run; a diagnosis that was broken off goes on as one
%! raw = standInCase (tempname ());
%! writeLoadInput (raw.folder);
%! [~, text] = startCommand (raw.folder, 'status');
%! assert (! isempty (strfind (text, 'Start with decalioc run')), text);
%! assert (! isempty (strfind (text, 'of 16 runs done; a start may add 40')));
%! Case = newCase (raw);
%! jobs = [newJobs(Case, [1, 2], [], 1, 'plan'), ...
%!         newJobs(Case, [2, 2], [], 1, 'calibration'), ...
%!         newJobs(Case, [2, 3], [], 1, 'gap')];
%! runJobs (jobs, Case, @(state) []);
%! [~, text] = startCommand (raw.folder, 'status');
%! assert (! isempty (strfind (text, 'Go on with decalioc diagnose')), text);
%! assert (! isempty (strfind (text, 'then 2 runs of 1 set; a start')));
%! % runs of an earlier input that are samples of this one are not left aside
%! writeAtomic (fullfile (Case.models(1).folder, 'extra'), 'x');
%! [~, text] = startCommand (raw.folder, 'status');
%! assert (! isempty (strfind (text, 'of an earlier model or input, left aside')), text);
%! mkdir (fullfile (raw.folder, 'results'));
%! writeAtomic (fullfile (raw.folder, 'results', 'library.csv'), ...
%!              "# x\nnumber,run,model,case\n1,1,First,\n");
%! [~, text] = startCommand (raw.folder, 'status');
%! assert (! isempty (strfind (text, "of an earlier model or input\n")), text);

% SPDX-License-Identifier: GPL-3.0-only
