% SAYOLDRUNS  Says how many finished runs of the store count no longer, and why.
%
% CALL: sayOldRuns (CASE, SAY, TALLY)
%
%   CASE  see newCase;  TALLY  see libraryRuns
%   SAY   function handle that takes one line of text
%
% Of a store that cases share: how many of its runs are samples here, too; of
% the case's own: how many of other limits, targets, samples or seed are. The
% reason is that of the newest of them. Runs of a diagnosis belong to its
% effects and are left out.

function sayOldRuns (Case, say, tally)
  if ~all (cellfun (@isfolder, {Case.models.folder}))
    return
  elseif sharesStore (Case)
    sayLibrary (tally, Case, say);
    return
  end
  if ~isempty (tally)
    sayOwn (tally, say);
  end
  h = hashModels (Case);
  for k = 1:numel (Case.models)
    name = Case.models(k).name;
    place = runPlace (Case, name);
    names = listRunFolders (place);
    jobs = cellfun (@(n) inOrderOf (finishedRun (fullfile (place, n)), Case.names), ...
                    names, 'UniformOutput', false);
    isOld = cellfun (@(j, n) ~isempty (j) && ...
                     isempty (countsToday (j, fullfile (place, n), Case, ...
                                           h(k))), jobs, names);
    if isempty (names)
      sayRenamed (Case, name, h(k), say);
    elseif any (isOld)
      last = find (isOld, 1, 'last');
      folder = fullfile (place, names{last});
      say (sprintf ('old runs  %s: %s. The newest (%s): %s', name, ...
                    countText (sum (isOld), 'finished run of the store does not count', ...
                               'finished runs of the store do not count'), ...
                    folder, whyOld (jobs{last}, folder, Case, ...
                                    Case.models(k))));
    end
  end
end

% A model without any run, and another of the same files and CPUs that is no more.
function sayRenamed (Case, name, h, say)
  others = readdir (runPlace (Case));
  for other = setdiff (others(:)', {Case.models.name, '.', '..'})
    place = runPlace (Case, other{1});
    folders = listRunFolders (place);
    if isempty (folders)
      continue
    end
    job = readRun (fullfile (place, folders{end}));
    if ~isempty (job) && strcmp (job.input, h.input)
      say (sprintf (['old runs  %s: none, but %s of the same model in %s. Call the ' ...
                     'model %s again (its folder, and in loadInput.m) and start anew ' ...
                     'to use them'], name, countText (numel (folders), 'run', 'runs'), ...
                    place, other{1}));
    end
  end
end

function sayOwn (tally, say)
  far = tally.outside(2);
  if tally.used + far > 0
    left = '';
    if far > 0
      left = sprintf (', %d too far outside the limits', far);
    end
    say (['own runs  the input has changed: ', ...
          countText(tally.used, 'earlier run is reused', 'earlier runs are reused'), ...
          left]);
  end
end

function sayLibrary (tally, Case, say)
  of = [' of ', countText(numel (tally.origin), 'case')];
  say (sprintf ('library   %s: %s here', Case.store, ...
                countText (tally.used, ['run', of, ' is a sample'], ...
                           ['runs', of, ' are samples'])));
  [~, order] = sort (-tally.count);
  for k = order(1:min (end, 3))
    name = [tally.origin{k}, repmat('(no case noted)', 1, ...
                                    isempty (tally.origin{k}))];
    say (sprintf ('          %d of %s', tally.count(k), name));
  end
  for part = tally.passed
    say (sprintf ('          %s: %s not used, %s', part.model, ...
                  countText (part.count, 'run is', 'runs are'), part.why));
  end
  for part = tally.other
    model = Case.models(part.model);
    folder = runPlace (Case, model.name, sprintf ('%04d', part.number));
    job = readSane (fullfile (folder, 'record.json'));
    if isempty (job)
      continue
    end
    say (sprintf ('          %s: %s not used. The newest (%s): %s', model.name, ...
                  countText (part.count, 'run of another rig or build is', ...
                             'runs of another rig or build are'), ...
                  folder, whyOld (job, folder, Case, model)));
  end
end

function job = finishedRun (folder)
  job = readRun (folder);
  if ~isempty (job) && ...
     (~any (strcmp (givenField (job, 'status', 'ok'), {'ok', 'invalid'})) || ...
      any (strcmp (job.stage, {'gap', 'cure'})))
    job = [];
  end
end

function text = whyOld (job, folder, Case, model)
  cpu = str2double (checkReadText (fullfile (folder, 'cpu')));
  changed = changedFiles (model.folder, folder);
  if numel (job.params) ~= numel (Case.names)
    text = sprintf ('it has %s, the case has %d', ...
                    countText (numel (job.params), 'parameter'), numel (Case.names));
  elseif ~isempty (changed)
    text = sprintf ('the model has changed since: %s', ...
                    strjoin (changed, ', '));
  elseif ~isnan (cpu) && cpu ~= model.cpu
    text = sprintf ('it took %s, Input.cpu is %d', countText (cpu, 'CPU'), model.cpu);
  else
    text = otherVariables (job, folder, Case, model);
  end
end

% Those of the models that a run has started from, too (Fill/runscript).
function changed = changedFiles (model, run)
  head = checkReadText (fullfile (model, 'data.head'));
  old = checkReadText (fullfile (run, 'data.head'));
  changed = otherFiles (model, run);
  if ~strncmp (old, head, numel (head))
    changed = [{'data.head'}, changed];
  end
  [names, folders] = stagesOf (model);
  for k = 1:numel (names)
    stage = changedFiles (folders{k}, fullfile (run, names{k}));
    changed = [changed, strcat([names{k}, '/'], stage)];
  end
end

function names = otherFiles (model, run)
  aside = {'OctaveFuns', 'sample', '.git'};
  skip = cellfun (@(n) ['-path ./', n, ' -prune -o '], aside, ...
                  'UniformOutput', false);
  command = ['cd ', shellQuote(model), ' && find -L . ', skip{:}, ...
             '-type f ! -name data.head ! -name "README*" ', ...
             '! -name "picture.*" ! -name log.liggghts ', ...
             '! -name settings.csv ! -name scatter.csv ! -name form.csv ', ...
             '! -name photo.jpg ', ...
             '-exec sh -c ''for f; do cmp -s "$f" "$0/$f" || echo "$f"; ', ...
             'done'' ', shellQuote(run), ' {} +'];
  [~, text] = system (command);
  names = regexp (text, '(?<=\./)[^\n]+', 'match');
end

function text = otherVariables (job, folder, Case, model)
  if numel (job.effects) ~= numel (Case.effectVars)
    job.effects = neutralEffects (Case);
  end
  then = headDefaults (fullfile (folder, 'data.head'));
  now = runVariables (job, Case);
  text = ['it was made with another LIGGGHTS than the one that is found now, or ' ...
          'with a file that its scripts name and that is gone'];
  outside = namedFiles (model.folder, folder);
  if ~isempty (outside)
    text = sprintf (['it was made with another form of what the scripts ' ...
                     'name (%s), or with another LIGGGHTS'], ...
                    strjoin (outside, ', '));
  end
  for name = fieldnames (now)'
    value = now.(name{1});
    if ~isfield (then, name{1}) || ...
       abs (then.(name{1}) - value) > 1e-12 * abs (value)
      text = sprintf ('its %s is not %g', name{1}, value);
    end
  end
end

%!function text = said (Case, tally)
%!  text = evalc ('sayOldRuns (Case, @(t) printf (''%s\n'', t), tally)');
%!endfunction
%!test
%! Case = readyCase ();
%! evaluateDEM ([1, 2; 3, 4], Case);
%! assert (said (Case, []), '');
%! other = Case;
%! other.names = {'b', 'a'};              % the same runs: libraryRuns takes them
%! assert (said (other, []), '');
%! other = Case;
%! other.modelVars.c = 3;
%! assert (~isempty (strfind (said (other, []), 'its c is not 3')));
%! other = Case;
%! other.models(1).cpu = 2;
%! text = said (other, []);
%! assert (~isempty (strfind (text, 'First: 2 finished')));
%! assert (~isempty (strfind (text, 'took 1 CPU, Input.cpu is 2')));
%! assert (isempty (strfind (text, 'Second')));
%! script = fullfile (Case.models(1).folder, 'runscript');
%! writeAtomic (script, [fileread(script), "# liggghts\n"]);
%! assert (~isempty (strfind (said (Case, []), 'changed since: runscript')));
%! % another build
%! evaluateDEM ([1, 2; 3, 4], Case);
%! writeAtomic (fullfile (Case.models(1).folder, 'photo.jpg'), 'no matter');
%! tidy = slurmFake ('', '', {'liggghts', 'other'});
%! text = said (Case, []);
%! clear tidy
%! assert (~isempty (strfind (text, '4 finished')));
%! assert (~isempty (strfind (text, 'another LIGGGHTS')));
%!test
%! % of a model that has another name now
%! Case = readyCase ();
%! evaluateDEM ([1, 2], Case);
%! place = @(name) fullfile (Case.store, 'optim', name);
%! rename (place ('First'), place ('Former'));
%! text = said (Case, []);
%! assert (~isempty (regexp (text, 'First: none, but 1 run .*Call the model Former again')));
%! assert (isempty (strfind (text, 'Second')));
%!test
%! % of a model from which the runs have started
%! raw = standInCase (tempname ());
%! model = @(varargin) fullfile (raw.folder, 'DEMmodels', varargin{:});
%! copyfile (model ('First'), model ('Fill'));
%! writeAtomic (model ('First', 'startsFrom'), "Fill\n");
%! Case = newCase (raw);
%! evaluateDEM ([1, 2; 3, 4], Case);
%! assert (said (Case, []), '');
%! script = model ('Fill', 'runscript');
%! writeAtomic (script, [fileread(script), "# more\n"]);
%! text = said (newCase (raw), []);
%! assert (~isempty (regexp (text, 'First: .*changed since: Fill/runscript')), text);
%!test
%! % of a store that cases share: samples, and what differs in the others
%! first = readyCase ();
%! evaluateDEM ([1, 2; 3, 4], first);
%! raw = standInCase (tempname ());
%! raw.Input.store = first.store;
%! Case = newCase (raw);
%! script = fullfile (Case.models(1).folder, 'runscript');
%! writeAtomic (script, [fileread(script), "# new\n"]);
%! [~, tally] = libraryRuns (Case, newProblem (Case), true);
%! text = said (Case, tally);
%! for words = {'2 runs of 1 case are samples here', ...
%!              ['2 of ', first.folder], 'First: 2 runs of another rig', ...
%!              'changed since: runscript'}
%!   assert (~isempty (strfind (text, words{1})), words{1});
%! end

% SPDX-License-Identifier: GPL-3.0-only
