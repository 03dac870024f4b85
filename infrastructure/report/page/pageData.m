% PAGEDATA  Gathers what the report page shows from the files of a case.
%
% CALL: PAGE = pageData (CASE)
%
%   CASE  see newCase
%   PAGE  scalar struct: of a case of one cost (isCost) Case, and best, see
%         bestKnown; else that of shownResult, and
%     surrogates  1 x T struct array or []: the last ones, else those after the
%                 plan
%     posterior   n x d, sample of the values that fit;  plan  n x d, parameter
%                 values of the plan;  found  1 x d, the best so far; 0 x d: none
%                 yet;  foundWord  what they are called (text)
%     runs        1 x n struct array, all that the store knows in the order of
%                 their starts: model, name (of the folder), stage, params (1 x
%                 d), effects, replicate, seed, status ('ok': ended well,
%                 without results where they are to be read anew; 'failed',
%                 'timeout', 'invalid', 'not ended'), cause, message, results,
%                 seconds, started (s since 1970; NaN: unknown); [] for none
%     reach       T x 2, least and largest mean response of each surrogate over
%                 the runs and 500 points of the limits; NaN: no surrogate
%     tables      see statementTables; change_NAME: table change of each condition
%                 but the first, which has all other tables
%
% A file that is not there, or cannot be read, leaves its field empty. Nothing
% is run, evaluated or changed.

function page = pageData (Case)
  if Case.isCost
    page = struct ('Case', Case, 'best', bestKnown (Case));
    return
  end
  Case.hashes = hashModels (Case);      % asked for several times
  results = fullfile (Case.folder, 'results');
  plan = readMatrix (fullfile (Case.folder, 'ExperimentalPlan_DoE.csv'), 0, Case);
  runs = storedRuns (Case);
  page = shownResult (Case, ~isempty (runs) || ~isempty (plan));
  s = page.sources;
  page.posterior = readMatrix (fullfile (results, 'posterior.csv'), 1, Case);
  places = {fullfile(results, 'surrogates'), ...
            fullfile(Case.folder, 'KrigingFuns')};
  if isempty (s.calibration)
    page.posterior = page.posterior([], :);
    places(1) = [];
  end
  page.surrogates = [];
  for place = fliplr (places)
    found = quietly (@() readSurrogates (place{1}, Case));
    if ~isempty (found)
      page.surrogates = found;
    end
  end
  [page.plan, page.runs] = deal (plan, runs);
  page.found = foundSet (s, Case.names);
  page.foundWord = merge (page.verdict.usable, 'the calibrated values', 'the best values so far');
  page.reach = reachOf (page.surrogates, Case);
  page.tables = withConditions (statementTables (page), page);
end

% A diagnosis of another condition that has been made since is none of this one's.
function tables = withConditions (tables, page)
  for one = jsonList (page.sources.gap, {'reference', 'conditions'})(2:end)
    gap = readJsonFile (fullfile (page.Case.folder, 'gap', one{1}.name, 'gap.json'));
    cause = jsonAt (gap, {'verdict', 'cause'});
    if ~isempty (cause) && isequaln (jsonAt (gap, {'which', 'p'}), one{1}.p)
      [page.sources.gap, page.verdict.cause] = deal (gap, cause);
      name = matlab.lang.makeValidName (['change_', one{1}.name]);
      T = statementTables (page, {'change'}).change;
      tables.(name) = setfield (T, 'notes', setdiff (T.notes, tables.change.notes, 'stable'));
    end
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

%!test
%! % a case of which nothing has been run
%! Case = readyCase ();
%! page = pageData (Case);
%! assert (isempty (page.sources.calibration));
%! assert (size (page.plan), [0, 2]);
%! assert (isempty (page.runs));
%! % files that are no such files
%! mkdir (fullfile (Case.folder, 'results'));
%! mkdir (fullfile (Case.folder, 'gap'));
%! for name = {'results/calibration.json', 'gap/gap.json', ...
%!             'ExperimentalPlan_DoE.csv'}
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

%!test
%! % each condition has its table of what has changed, unless it was judged anew since
%! raw = standInCase (tempname ());
%! list = verdictCase ();
%! verdictCase (raw.folder, list(strcmp ({list.name}, 'missed, named')));
%! file = fullfile (raw.folder, 'gap', 'gap.json');
%! gap = jsondecode (fileread (file));
%! target = struct ('model', 'First', 'name', 'h', 'reference', 1, 'measured', 3, ...
%!                  'modelled', NaN, 'sd', 0.5, 'kind', '', 'series', '', 'unit', '');
%! one = struct ('name', {'wet', 'dry'}, 'verdict', 'no gap', 'code', 'none', 'kind', ...
%!               'none', 'effects', {{}}, 'p', 0.2);
%! gap.reference = struct ('condition', 'wet', 'targets', target, 'conditions', one);
%! writeAtomic (file, jsonencode (gap));
%! [gap.which.p, gap.reference.condition] = deal (0.2, 'dry');
%! mkdir (fullfile (raw.folder, 'gap', 'dry'));
%! other = fullfile (raw.folder, 'gap', 'dry', 'gap.json');
%! gap.verdict.cause = struct ('code', 'none');
%! writeAtomic (other, jsonencode (gap));
%! tables = pageData (newCase (raw)).tables;
%! assert (! isempty (strfind (tables.change.title, 'wet')));
%! assert (! isempty (strfind (tables.change_dry.title, 'dry')));
%! gap.which.p = 0.3;
%! writeAtomic (other, jsonencode (gap));
%! assert (! isfield (pageData (newCase (raw)).tables, 'change_dry'));

% SPDX-License-Identifier: GPL-3.0-only
