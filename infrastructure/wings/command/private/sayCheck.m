% SAYCHECK  Checks a case and says what its calibration will cost.
%
% CALL: STATUS = sayCheck (ROOT, FOLDER, ARGS)
%
%   ROOT    folder of the toolbox (text)
%   FOLDER  case folder (text)
%   ARGS    cell of texts: '--try' makes one run of each model, '--dry-run'
%           shows what a queue would get; the queue need not be here then
%   STATUS  0; 2 where a trial run has failed
%
% Errors: DEcalioc:sayCheck:badValue (both options); those of loadCase and
% withEffects, which list all mistakes, and of ownCost

function status = sayCheck (root, folder, args)
  options = commandOptions (args, struct ('try', 'flag', 'dry_run', 'flag'));
  if options.try && options.dry_run
    error ('DEcalioc:sayCheck:badValue', ...
           ['check takes --try, which makes runs, or --dry-run, which makes ' ...
            'none, got both. Call it once with each.']);
  end
  choice = useLiggghts (root);
  how = repmat ({'reading'}, 1, options.dry_run);
  Case = withEffects (loadCase (root, folder, how{:}));
  Case.hashes = hashModels (Case);     % asked for several times
  if ~Case.isCost
    ownCost ();
  end
  printf ('case      %s: no mistake found\n', folder);
  cellfun (@(text) printf ('WARNING   %s.\n', text), Case.notes, ...
           'UniformOutput', false);
  sayModels (Case, options.try);
  % a case of imported runs alone starts nothing
  isRun = any (isfile (fullfile ({Case.models.folder}, 'runscript')));
  if isRun
    printf ('LIGGGHTS  %s %s\n          why: %s\n          %s\n', ...
            givenField (choice, 'program', 'none'), choice.version, ...
            choice.why, choice.how);
  end
  sayBox (Case);
  sayEffects (Case);
  status = 0;
  if Case.isCost
    b = bestKnown (Case);
    printf ('cost      %s: the smallest of %s counts\n', b.name, countText (b.sets, 'set'));
    return
  end
  if options.try
    % before the costs: the trial tells how long a run takes
    lock = lockCase (folder);
    status = 2 * ~sayTrial (tryModels (Case), Case);
  end
  f = foresee (Case, runsOfCase (Case), @sayWarning);
  sayCosts (Case, isRun, f);
  lines = diagnosisCost (Case, f);
  names = {'diagnosis ', repmat(' ', 1, 10)};
  for k = 1:numel (lines)
    printf ('%s%s\n', names{1 + (k > 1)}, lines{k});
  end
  if options.dry_run
    sayDryRun (Case, f);
  end
end

function sayImported (Case, data)
  if ~isempty (data.X)
    [~, isIn] = insideLimits (data.X, Case.limits);
    within = sprintf (', %d of them between the limits', sum (isIn));
    printf ('runs.csv  %s taken in%s\n', countText (rows (data.X), 'set'), ...
            within(1:end * ~all (isIn)));
    sayUnits (Case.targets, data.Z, 'in the middle of runs.csv');
  end
end

% Of what a calibration says of runs.csv.
function sayWarning (text)
  text = strtrim (text);
  if strncmp (text, 'WARNING', 7)
    printf ('WARNING   %s\n', text(10:end));
  end
end

% Before a trial run, which says it of its own results, earlier runs tell of units.
function sayModels (Case, isTried)
  earlier = NaN (size (Case.targets));
  if ~isTried
    [~, ~, earlier] = earlierScatter (Case);
  end
  for k = 1:numel (Case.models)
    m = Case.models(k);
    place = givenField (m, 'folder', ...
                        'no folder; its runs are those of runs.csv');
    mine = Case.targets([Case.targets.model] == k);
    printf ('model     %s: %s, %s a run (%s)\n', m.name, ...
            countText (numel (requirementsOf (mine, 1:numel (mine))), 'target'), ...
            countText (m.cpu, 'CPU'), place);
    sayStages (m);
    cellfun (@(text) printf ('WARNING   %s: %s\n', m.name, text), ...
             notesOfInput (m.folder, Case, mine));
    sayNamed (m, Case.hashes(k).named);
    isMine = [Case.targets.model] == k;
    sayMeasured (Case.targets(isMine));
    sayThinned (Case.thinned, k);
    sayUnits (Case.targets(isMine), earlier(isMine), 'in scatter.csv of the model');
  end
  for note = Case.scatterNotes
    printf ('%-9s %s\n', note.label, note.text);
  end
end

function sayThinned (thinned, k)
  if ~isempty (thinned) && any ([thinned.model] == k)
    printf (['          %s of its dense curves are not fitted: neighbours say the ' ...
             'same\n'], countText (sum ([thinned.model] == k), 'point'));
  end
end

function sayStages (model)
  [names, folders] = stagesOf (model.folder);
  for k = 1:numel (names)
    printf ('          starts from %s, run once for a set and a packing (%s)\n', ...
            names{k}, folders{k});
    sayStages (struct ('folder', folders{k}));
  end
end

% What the scripts of a model name outside its folder.
function sayNamed (model, named)
  if isempty (model.folder)
    return
  end
  [notes, codes] = modelNotes (model.folder);
  notes = notes(~strcmp (codes, 'unused'));    % said above, of all models
  cellfun (@(text) printf ('WARNING   %s: %s.\n', model.name, text), notes);
  cellfun (@(file) printf (['WARNING   %s: a run writes to %s, outside its folder: ' ...
                            'runs at the same time write there, too, and read each ' ...
                            'other''s results. Write into the folder of the run ' ...
                            '(docs/extend.md)\n'], model.name, file), named.written);
  cellfun (@(file) printf (['          %s: named by its scripts; a change ' ...
                            'there asks for new runs\n'], file), named.files);
  cellfun (@(text) printf (['          %s: named by its scripts, but a ' ...
                            'change there is NOT noticed: forget the runs ' ...
                            'then (decalioc forget)\n'], text), named.open);
end

% What measured.csv makes of the targets of a model.
function sayMeasured (targets)
  [groups, ~, isJoint] = requirementsOf (targets, 1:numel (targets));
  for group = groups(isJoint)
    printf ('          curve %s: %s, one requirement\n', ...
            targets(group{1}(1)).series, countText (numel (group{1}), 'point'));
  end
  isOther = ~cellfun (@isempty, {targets.given}) & ...
            ~strcmp ({targets.given}, {targets.unit});
  sayList ('converted to the unit of results.csv', ...
           unique (strcat ({targets(isOther).given}, {' to '}, ...
                           {targets(isOther).unit})));
  isMean = arrayfun (@(t) numel (givenField (t, 'each', [])) > 1, targets);
  miss = arrayfun (@(t) t.value - mean (givenField (t, 'each', t.value)), targets);
  isPlain = abs (miss) < 1e-9 * abs ([targets.value]);
  sayList ('mean of repeated trials', {targets(isMean & isPlain).name});
  sayList ('mean of repeated trials, weighted by their sd, repeats and sessions', ...
           {targets(isMean & ~isPlain).name});
  isMixed = arrayfun (@(t) givenField (t, 'mixed', false), targets);
  sayList ('the sd that some trials have do not weigh them, as others have none', ...
           {targets(isMixed).name});
  sayList ('not measured yet, predicted only', ...
           {targets(isnan ([targets.value])).name});
  sayOdd (targets);
  sayTight (targets);
end

% One reading that is no trial of the same: 15 times the scatter of the others away from
% their mean (of five, one in 200 quantities by chance), and of what they have 15 % at least.
function sayOdd (targets)
  for t = targets(arrayfun (@(t) numel (givenField (t, 'each', [])) > 4, targets))
    n = numel (t.each);
    others = arrayfun (@(i) t.each([1:i - 1, i + 1:n]), 1:n, 'UniformOutput', false);
    middle = cellfun (@mean, others);
    [times, k] = max (abs (t.each - middle) ./ max (cellfun (@std, others), ...
                                                    0.01 * abs (middle)));
    if times > 15
      printf (['WARNING   %s: one reading, %.5g, is %.0f times the scatter of the other ' ...
               '%d away from their mean, %.5g%s: is it in another unit, or its point ' ...
               'misplaced?\n'], ...
              t.name, t.each(k) / t.shown.factor, times, n - 1, middle(k) / t.shown.factor, ...
              unitBehind (t));
    end
  end
end

% Tighter than anybody can measure it: a share of a value that is next to 0, or a slip.
function sayTight (targets)
  isFit = strcmp ({targets.role}, 'calibrate') & isfinite ([targets.value]);
  for t = targets(isFit)
    if t.sd > 3 * halfWidth (t)
      unit = unitBehind (t);
      printf (['WARNING   %s: its uncertainty (%.3g%s) is %.2g times its tolerance ' ...
               '(+- %.3g%s): no run can show that it is met. Write a tolerance in its ' ...
               'unit (column tol: 0.1 abs), or measure it more often\n'], t.name, ...
              t.sd / t.shown.factor, unit, t.sd / halfWidth (t), ...
              halfWidth (t) / t.shown.factor, unit);
    end
  end
end

function text = unitBehind (target)
  text = regexprep (regexprep (target.shown.unit, '^-$', ''), '^.', ' $0');
end

function sayList (what, names)
  if ~isempty (names)
    printf ('          %s: %s\n', what, strjoin (names, ', '));
  end
end

% In which scale, and where, the sets lie.
function sayBox (Case)
  why = {'as Input.scale says', ['its limits are more than a factor of 100 ' ...
                                 'apart; Input.scale says otherwise']};
  for j = find (any (Case.limits(3:end, :), 1))
    printf ('scale     %s: counted in logarithms, %s\n', Case.names{j}, ...
            why{1 + Case.bySelf(j)});
  end
  if isempty (Case.allowed)
    return
  end
  for j = find (~cellfun (@isempty, Case.allowed.values))
    values = Case.allowed.values{j};
    printf ('values    %s: %s\n', Case.names{j}, ...
            strjoin (arrayfun (@(v) sprintf ('%g', v), values, ...
                               'UniformOutput', false), ', '));
  end
  for text = Case.allowed.texts
    printf ('allowed   %s\n', text{1});
  end
  if ~isempty (Case.allowed.texts)
    printf ('          %.2g %% of the sets between the limits\n', ...
            100 * Case.allowed.share);
  end
end

function sayEffects (Case)
  for coarse = Case.coarse
    printf ('levels    %s: %s; the last one counts\n', coarse.variable, ...
            strjoin (arrayfun (@num2str, coarse.levels, ...
                               'UniformOutput', false), ', '));
  end
  if ~isempty (Case.effects)
    printf ('effects   %s\n', strjoin ({Case.effects.name}, ', '));
    [texts, nowhere] = unexpressedEffects (Case);
    cellfun (@(text) printf ('          %s\n', text), texts);
    if all (nowhere)
      printf (['WARNING   no candidate of loadEffects.m can act here: ' ...
               'decalioc diagnose will not begin.\n']);
    end
  end
  if ~isempty (Case.conditions)
    cellfun (@(text) printf ('%s\n', text), askChange (Case), ...
             'UniformOutput', false);
    sayUnitsOfChanges (Case);
  end
end

% Logarithms have no unit.
function sayUnitsOfChanges (Case)
  targets = Case.targets(~strncmp ({targetInfo(Case).kind}, 'log', 3));
  for c = 1:numel (Case.conditions)
    values = arrayfun (@(T) T.changed(c).value, targets);
    sayUnits (targets, values, ['in ', Case.conditions{c}]);
  end
end

% The first set of the plan, from which a calibration takes it out of the store;
% where runs.csv has the whole plan, the middle of the box.
function records = tryModels (Case)
  f = foresee (Case, struct ('model', {}, 'job', {}, 'state', {}, ...
                             'seconds', {}));
  if isempty (f.plan)
    f.plan = toAllowed (boxCentre (Case.limits), Case);
  end
  jobs = newJobs (Case, f.plan(1, :), [], 1, 'plan');
  printf (['trial     one run of %s begins; decalioc status says in another terminal ' ...
           'how long it has run\n'], strjoin ({Case.models.name}, ', of '));
  fflush (stdout);
  records = runJobs (jobs, Case, newProgress ('trial', ...
                                              @(text) printf ('%s\n', text)));
end

function isGood = sayTrial (records, Case)
  wasRun = ~strcmp ({records.cause}, 'budget');
  isGood = all (strcmp ({records(wasRun).status}, 'ok'));
  for r = records(~wasRun)
    printf ('trial     %s: %s\n', r.model, r.message);
  end
  for k = find (wasRun)
    r = records(k);
    printf ('trial     %s: %s, %.1f s (%s)\n', r.model, r.status, r.seconds, ...
            r.folder);
    if ~strcmp (r.status, 'ok')
      printf ('          %s\n', r.message);
      continue
    end
    mine = Case.targets([Case.targets.model] == k);
    g = sayGrains (r);
    sayResults (r, mine);
    notes = trialGates (r, mine, Case.models(k).folder, g);
    notes = notes(~ismember (notes, notesOfInput (Case.models(k).folder, Case, mine)));
    cellfun (@(text) printf ('WARNING   %s: %s\n', r.model, text), notes);
  end
end

% What needs no run to be seen: of the variables, and of what was measured.
function notes = notesOfInput (folder, Case, targets)
  notes = cell (1, 0);
  head = fullfile (folder, 'data.head');
  if isfile (head)
    values = mergeFields (headDefaults (head), Case.modelVars);
    for T = targets(isfinite ([targets.value]))
      values.(T.name) = T.value;
    end
    notes = inputGates (folder, values);
  end
end

function sayResults (r, targets)
  if ~isempty (r.message)
    printf ('WARNING   %s: %s.\n', r.model, r.message);
  end
  for T = targets
    measured = strtrim (sprintf ('measured %.5g %s', T.value / T.shown.factor, ...
                                 T.shown.unit));
    if isnan (T.value)
      measured = 'not measured yet';
    end
    printf ('          %-24s %.5g, %s\n', T.name, r.results(T.index) / T.shown.factor, ...
            measured);
  end
  sayUnits (targets, r.results([targets.index]), 'in this run');
end

% Grains that are not there, and what LIGGGHTS itself warned of: the run ends well.
function g = sayGrains (r)
  g = grainsOfRun (r.folder);
  if g.made > 0
    asked = '';
    if ~isnan (g.asked)
      asked = sprintf (' of %d that the script asks for', g.asked);
    end
    glued = repmat (sprintf (' (and %d glued to the rig)', g.glued), 1, g.glued > 0);
    printf ('          grains: %d%s were filled in%s, %d of them are there at the end\n', ...
            g.made, asked, glued, g.left);
  end
  cellfun (@(text) printf ('WARNING   %s: LIGGGHTS says: %s.\n', r.model, text), ...
           g.warnings);
  if g.made == 0 && g.asked > 0
    printf (['WARNING   %s: none of %d grains is there at the end of a command run: they ' ...
             'were lost, or never came. See that walls and a floor hold them, write ' ...
             'thermo_modify lost error, and enlarge the region of the insertion.\n'], ...
            r.model, g.asked);
  elseif g.made < g.asked && isempty (g.warnings)
    printf (['WARNING   %s: fewer grains than the script asks for. Enlarge the region ' ...
             'of the insertion, or ask for fewer.\n'], r.model);
  end
  if g.made > 0 && g.left == 0
    printf (['WARNING   %s: %d of %d grains were lost: none is there at the end. See ' ...
             'that walls and a floor hold them, and write thermo_modify lost error.\n'], ...
            r.model, g.made, g.made);
  end
end

% F: see foresee.
function sayCosts (Case, isRun, f)
  n = numel (f.isDone);
  o = Case.options;
  sayImported (Case, f.imported);
  if ~isRun
    return
  end
  m = numel (Case.models);
  printf ('runs      plan: %s, %d new, %d taken from the store\n', ...
          asRuns (rows (f.plan), m), n - sum (f.isDone), sum (f.isDone));
  sayOldRuns (Case, @(text) printf ('%s\n', text), f.library);
  printf ('          then at most %s (optim.maxFunEvals)\n', ...
          asRuns (o.maxFunEvals, m));
  if isfinite (o.maxNewRuns)
    printf ('          at most %s in a start (Input.maxNewRuns)\n', ...
            countText (o.maxNewRuns, 'new run'));
  end
  if isnan (f.planHours)
    printf (['cost      not known: no run has finished yet. decalioc check ' ...
             '--try makes one of each model\n']);
  else
    printf ('cost      plan %.2g core-hours, at most %.2g in all\n', ...
            f.planHours, f.mostHours);
    if strcmp (o.executor, 'local')
      printf ('          on %s (Input.maxCPU): plan %s, at most %s\n', ...
              countText (o.maxCPU, 'CPU'), inWords (f.planHours * 3600 / o.maxCPU), ...
              inWords (f.mostHours * 3600 / o.maxCPU));
    end
  end
end

% What the runs of the plan that are missing would be started with.
function sayDryRun (Case, f)
  jobs = f.jobs(~f.isDone);
  what = describeExecutor (Case.options.executor);
  if isempty (jobs)
    printf ('dry run   nothing would be started: the plan has all its runs\n');
  elseif what.isHere
    printf (['dry run   nothing is started. %s would start on this machine, on %s; ' ...
             'Input.executor = ''slurm'' or ''gridengine'' submits them to a queue\n'], ...
            countText (numel (jobs), 'run'), countText (Case.options.maxCPU, 'CPU'));
  else
    printf ('%s', what.preview (jobs, Case));
  end
end

% All is counted in runs; a parameter set is run once with each model.
function text = asRuns (sets, models)
  text = sprintf ('%s x %s = %s', countText (sets, 'parameter set'), ...
                  countText (models, 'model'), countText (sets * models, 'run'));
end

%!test
%! raw = standInCase (tempname ());
%! writeLoadInput (raw.folder);
%! [status, text] = startCommand (raw.folder, 'check');
%! assert (status, 0);
%! for line = {'no mistake found', 'First: 2 targets, 1 CPU a run', ...
%!             'plan: 8 parameter sets x 2 models = 16 runs, 16 new, 0 taken from', ...
%!             'most 40 parameter sets x 2 models = 80 runs', ...
%!             'cost      not known'}
%!   assert (! isempty (strfind (text, line{1})), text);
%! end

%!test
%! % of a change: sessions, and what can have changed, are asked for
%! raw = standInCase (tempname ());
%! writeLoadInput (raw.folder, 'optim = struct (''maxIter'', 3);');
%! put = @(name, text) writeAtomic (fullfile (raw.folder, name), text);
%! put ('DEMmodels/First/results.csv', ["name,kind,unit,series,at,text\n", ...
%!      "sum,mass,kg,,,x\nproduct,mass,kg,,,x\n"]);
%! put ('DEMmodels/Second/results.csv', ["name,kind,unit,series,at,text\n", ...
%!      "less,mass,kg,,,x\n"]);
%! put ('loadEffects.m', ["function e = loadEffects ()\n", ...
%!      "e = {'rolling', 'gain'};\nend\n"]);
%! lines = ["condition,model,name,value,tol,session\n", ...
%!          "reference,First,sum,7,0.01,mon\nreference,First,sum,7.1,,mon\n", ...
%!          "reference,First,sum,6.8,,tue\nreference,First,product,12,1%%,\n", ...
%!          "reference,Second,less,1,0.1,\nmoist,First,sum,8,,wed\n"];
%! put ('measured.csv', sprintf (lines));
%! [status, both] = startCommand (raw.folder, 'check');
%! assert (status, 0);
%! put ('measured.csv', strrep (sprintf (lines), 'tue', 'mon'));
%! [~, one] = startCommand (raw.folder, 'check');
%! put ('measured.csv', regexprep (sprintf (lines), ',\w*$', '', ...
%!                                 'lineanchors'));
%! [~, none] = startCommand (raw.folder, 'check');
%! has = @(text, line) assert (! isempty (strfind (text, line)), text);
%! has (both, 'sessions  sessions differ by');
%! has (one, 'taken to differ by 2.5 times');
%! has (none, 'repeat the reference on another day, and name the days');
%! has (both, 'unlikely to have changed, 0.05 as likely as those above: rolling');
%! has (both, 'Not said of: rolling, gain');

%!test
%! % five readings, of which one is no trial of the same; alike ones are not odd
%! raw = standInCase (tempname ());
%! writeLoadInput (raw.folder, 'optim = struct (''maxIter'', 3, ''tolRes'', 0.02);');
%! rows_ = cellfun (@(z) sprintf ("First,sum,%g\nFirst,product,%g\n", z), ...
%!                  {[7, 12], [7.1, 12], [690, 12], [6.9, 12], [7, 12.1]}, ...
%!                  'UniformOutput', false);
%! writeAtomic (fullfile (raw.folder, 'measured.csv'), ["model,name,value\n", rows_{:}, ...
%!              "Second,less,1\n"]);
%! writeAtomic (fullfile (raw.folder, 'DEMmodels', 'First', 'results.csv'), ...
%!              ["name,kind,unit,series,at,text\n", ...
%!               "sum,mass,kg,,,x\nproduct,mass,kg,,,x\n"]);
%! writeAtomic (fullfile (raw.folder, 'DEMmodels', 'Second', 'results.csv'), ...
%!              "name,kind,unit,series,at,text\nless,mass,kg,,,x\n");
%! [~, text] = startCommand (raw.folder, 'check');
%! assert (numel (strfind (text, 'is it in another unit, or its point')) == 1, text);
%! assert (! isempty (strfind (text, 'sum: one reading, 690, is')), text);

%!test
%! % what a queue would get, on a machine that has none
%! raw = standInCase (tempname ());
%! writeLoadInput (raw.folder, ['Input.executor = ''slurm''; ', ...
%!                              'Input.slurm.partition = ''long'';']);
%! tools = emptyFolder ();
%! system (['cd ', tools, ' && ln -sf /bin/* /usr/bin/* . 2> /dev/null; ', ...
%!          'rm -f sbatch squeue']);
%! before = getenv ('PATH');
%! back = onCleanup (@() setenv ('PATH', before));
%! setenv ('PATH', tools);
%! root = fileparts (fileparts (which ('startToolbox')));
%! here = cd (raw.folder);
%! there = onCleanup (@() cd (here));
%! clear loadInput
%! text = evalc ('sayCheck (root, raw.folder, {''--dry-run''});');
%! for part = {'no sbatch and squeue on the PATH', '--partition=long', ...
%!             '--array=1-16', 'job script: ', 'runscript'}
%!   assert (! isempty (strfind (text, part{1})), text);
%! end
%! assert (glob (fullfile (raw.folder, 'optim', '*')), cell (0, 0));
%! said = '';
%! try
%!   sayCheck (root, raw.folder, {});
%! catch err
%!   said = err.message;
%! end
%! assert (! isempty (strfind (said, 'a program sbatch on the PATH')), said);
%! clear back there
%! clear loadInput
%! writeLoadInput (raw.folder);
%! [~, text] = startCommand (raw.folder, 'check --dry-run');
%! assert (! isempty (strfind (text, '16 runs would start on this machine')));
%! [status, text] = startCommand (raw.folder, 'check --try --dry-run');
%! assert (status, 1);

% SPDX-License-Identifier: GPL-3.0-only
