% PAGEDATA  Gathers what the report shows from the files of a case.
%
% CALL: PAGE = pageData (CASE)
%
%   CASE  see newCase
%   PAGE  scalar struct:
%     Case        CASE, with its candidate effects where there is a gap/
%     sources     struct of decoded files, [] where there is none: calibration,
%                 progress, gap (JSON); gapTargets (CSV, struct array)
%     surrogates  1 x T struct array or []: the last ones, else those after the
%                 plan
%     posterior   n x d, sample of the sets that fit;  plan  n x d, parameter
%                 sets of the plan;  found  1 x d, the best set so far; 0 x d:
%                 none yet
%     runs        1 x n struct array, all that the store knows in the order of
%                 their starts: model, name (of the folder), stage, params (1 x
%                 d), effects, replicate, seed, status ('ok': ended well,
%                 without results where they are to be read anew; 'failed',
%                 'timeout', 'invalid', 'not ended'), cause, message, results,
%                 seconds, started (s since 1970; NaN: unknown); [] for none
%     units       1 x T cell of texts, '' where it is not known
%     reach       T x 2, least and largest mean response of each surrogate over
%                 the runs and 500 points of the box; NaN: no surrogate
%     verdict     see decideCase
%     isChange    logical: the diagnosis is one of a change;  showsEffect
%                 beside the targets stands what the effect makes of them
%
% A file that is not there, or cannot be read, leaves its field empty. Nothing
% is run, evaluated or changed.

function page = pageData (Case)
  results = fullfile (Case.folder, 'results');
  gap = fullfile (Case.folder, 'gap');
  [s, stored] = sourcesOf (Case, results);
  s.gapTargets = quietly (@() readTable (fullfile (gap, 'targets.csv')));
  if ~isempty (s.gap) && isempty (Case.effects)
    full = quietly (@() withEffects (Case));
    if ~isempty (full)
      Case = full;
    end
  end
  page.posterior = readMatrix (fullfile (results, 'posterior.csv'), 1, Case);
  places = {fullfile(results, 'surrogates'), ...
            fullfile(Case.folder, 'KrigingFuns')};
  if isempty (s.calibration)
    page.posterior = page.posterior([], :);
    places(1) = [];
  end
  page.sources = s;
  page.Case = Case;
  page.surrogates = [];
  for place = fliplr (places)
    found = quietly (@() readSurrogates (place{1}, Case));
    if ~isempty (found)
      page.surrogates = found;
    end
  end
  page.plan = readMatrix (fullfile (Case.folder, ...
                                    'ExperimentalPlan_DoE.csv'), 0, Case);
  page.runs = allRuns (Case);
  page.units = regexprep ({targetInfo(Case).unit}, '^-$', '');
  page.found = foundSet (s, Case.names);
  page.reach = reachOf (page.surrogates, Case);
  page.verdict = decideStored (stored, ~isempty (page.runs) || ...
                               ~isempty (page.plan));
  page.isChange = ~isempty (jsonAt (s.gap, {'reference'}));
  % beside the reference that was calibrated the effect of a change is no fit
  isOther = page.isChange && ~isempty (s.calibration);
  page.showsEffect = ~isOther && ...
                     ~isempty (jsonAt (page.verdict, {'cause', 'closed'}));
end

% No calibration while one is under way, or was broken off; no diagnosis of an
% earlier input beside a calibration of today's.
function [s, stored] = sourcesOf (Case, results)
  stored = storedResult (Case);
  s.progress = readJsonFile (fullfile (results, 'progress.json'));
  if ~isempty (s.progress)
    stored.calibration = [];
  end
  if isempty (stored.calibration)
    stored.changed = stored.gapChanged;
  end
  [s.calibration, s.gap] = deal (stored.calibration, stored.gap);
  if isempty (stored.changed) && ~isempty (stored.gapChanged)
    s.gap = [];
  end
end

% What F gives, [] where it fails.
function value = quietly (f)
  try
    value = f ();
  catch
    value = [];
  end
end

function list = readTable (file)
  [head, cells] = readCsvTable (file);
  values = num2cell (str2double (cells));
  isText = cellfun (@isnan, values) & ~cellfun (@isempty, cells);
  values(isText) = cells(isText);
  list = cell2struct (values, strrep (head, 'target', 'name'), 2);
end

function M = readMatrix (file, nHead, Case)
  d = numel (Case.names);
  M = quietly (@() dlmread (file, ',', nHead, 0));
  if columns (M) < d
    M = zeros (0, d);
  end
  M = M(:, 1:d);                        % levels stand behind
end

function surrogates = readSurrogates (folder, Case)
  surrogates = [];
  for t = 1:numel (Case.targets)
    file = fullfile (folder, sprintf ('KM_fun_%d.txt', t));
    surrogates = [surrogates, loadSurrogate(file)];
  end
  if any (cellfun (@columns, {surrogates.X}) ~= numel (Case.names))
    surrogates = [];                    % of another box
  end
end

function p = foundSet (sources, names)
  p = zeros (0, numel (names));
  for source = {sources.progress, sources.calibration}
    params = jsonAt (source, {1, 'params'});
    if all (isfield (params, names))
      p = cellfun (@(n) params.(n), names);
    end
  end
end

function reach = reachOf (surrogates, Case)
  reach = NaN (numel (Case.targets), 2);
  limits = Case.limits;
  u = integrationPoints (500, columns (limits), 1).uniform;
  for t = 1:numel (surrogates)
    s = surrogates(t);
    isInside = all (s.X >= limits(1, :) & s.X <= limits(2, :), 2);
    P = [fromUnit(u, limits); s.X(isInside, :)];
    m = predictSurrogate (s, P);
    reach(t, :) = [min(m), max(m)];
  end
end

% In a store that other cases share, only the own runs inside the limits count.
function runs = allRuns (Case)
  runs = [];
  slack = 1e-9 * diff (Case.limits(1:2, :));
  if strcmp (Case.store, Case.folder)
    slack = Inf;
  end
  if ~all (cellfun (@isfolder, {Case.models.folder}))
    return
  end
  h = hashModels (Case);
  for k = 1:numel (Case.models)
    model = Case.models(k).name;
    for name = runFoldersOf (Case, model)(:)'
      run = oneRun (fullfile (Case.store, 'optim', model, name{1}), name{1}, ...
                    h(k));
      if ~isempty (run) && numel (run.params) == numel (Case.names) && ...
         all (run.params >= Case.limits(1, :) - slack & ...
              run.params <= Case.limits(2, :) + slack)
        runs = [runs, run];
      end
    end
  end
  if ~isempty (runs)
    [~, order] = sort ([runs.started]);
    runs = runs(order);
  end
end

function run = oneRun (folder, name, h)
  run = [];
  record = readingOf (readSane (fullfile (folder, 'record.json')), h);
  if isempty (record)
    record = readSane (fullfile (folder, 'job.json'));
  end
  if isempty (record)
    return
  end
  run = struct ('model', '', 'name', '', 'stage', '', 'params', [], ...
                'effects', [], 'replicate', 1, 'seed', NaN, ...
                'status', 'not ended', 'cause', '', 'message', '', ...
                'results', [], 'seconds', NaN, 'started', NaN);
  for field = fieldnames (run)'
    if ~isempty (jsonAt (record, field))
      run.(field{1}) = record.(field{1});
    end
  end
  if strcmp (run.status, 'ended')
    run.status = 'ok';
    run.message = 'to be read anew: OctaveFuns or measured.csv have changed';
  end
  run.name = name;
  run.params = run.params(:)';
  % the end mark is written at the end; a run without one began with its job
  mark = stat (fullfile (folder, 'end.mark'));
  job = stat (fullfile (folder, 'job.json'));
  if ~isempty (mark) && isfinite (run.seconds)
    run.started = mark.mtime - run.seconds;
  elseif ~isempty (job)
    run.started = job.mtime;
  end
end

%!test
%! % a case of which nothing has been run
%! Case = newCase (standInCase (tempname ()));
%! page = pageData (Case);
%! assert (isempty (page.sources.calibration));
%! assert (size (page.plan), [0, 2]);
%! assert (isempty (page.runs));
%! % files that are no such files
%! mkdir (fullfile (Case.folder, 'results'));
%! mkdir (fullfile (Case.folder, 'gap'));
%! for name = {'results/calibration.json', 'gap/gap.json', ...
%!             'gap/targets.csv', 'ExperimentalPlan_DoE.csv'}
%!   writeAtomic (fullfile (Case.folder, name{1}), '{"a": ');
%! end
%! page = pageData (Case);
%! assert (isempty (page.sources.gap));
%! assert (isempty (page.surrogates));
%! % what fails is tried once more, with another seed
%! writeAtomic (fullfile (Case.folder, 'DEMmodels', 'Second', 'runscript'), ...
%!              "exit 3\n");
%! evaluateDEM ([1, 2; 3, 4], Case);
%! prepareRun (newJobs (Case, [5, 6], [], 1, 'plan')(1), Case);
%! runs = pageData (Case).runs;
%! assert (numel (runs), 7);
%! assert (sum (strcmp ({runs.status}, 'ok')), 2);
%! assert (sum (strcmp ({runs.status}, 'failed')), 4);
%! assert (sum (strcmp ({runs.status}, 'not ended')), 1);
%! assert (all (diff ([runs.started]) >= 0));
%! assert (sum (arrayfun (@(r) isequal (r.params, [3, 4]), runs)), 3);
