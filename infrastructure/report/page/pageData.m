% PAGEDATA  Gathers what the report shows from the files of a case.
%
% CALL: PAGE = pageData (CASE)
%
%   CASE  see newCase
%   PAGE  scalar struct:
%         Case        CASE, with its candidate effects where there is a gap/
%         sources     struct of decoded files, [] where there is none:
%                     calibration, progress, gap (JSON); gapTargets,
%                     gapEffects, gapConflicts (CSV, struct arrays)
%         surrogates  1 x T struct array or []: the last ones, else those after
%                     the plan
%         posterior   n x d, sample of the sets that fit; 0 x d: none yet
%         plan        n x d, parameter sets of the plan
%         runs        see pageRuns
%         units       1 x T cell of texts, '' where it is not known
%         found       1 x d, the best set so far; 0 x d: none yet
%         reach       T x 2, least and largest mean response of each surrogate
%                     over the runs and 500 points of the box; NaN: no surrogate
%         verdict     see decideCase
%         showsEffect logical: beside the targets what the effect makes of them
%         isRunning   a calibration is under way, or was broken off
%
% A file that is not there, or cannot be read, leaves its field empty.

function page = pageData (Case)
  results = fullfile (Case.folder, 'results');
  gap = fullfile (Case.folder, 'gap');
  s.calibration = readJsonFile (fullfile (results, 'calibration.json'));
  s.progress = readJsonFile (fullfile (results, 'progress.json'));
  s.gap = readJsonFile (fullfile (gap, 'gap.json'));
  s.gapTargets = readTable (fullfile (gap, 'targets.csv'));
  s.gapEffects = readTable (fullfile (gap, 'effects.csv'));
  page.isRunning = isempty (s.calibration) || ~isempty (s.progress);
  if page.isRunning
    s.calibration = [];
  end
  if ~isempty (s.gap)
    Case = candidates (Case);
  end
  page.sources = s;
  page.Case = Case;
  page.surrogates = readSurrogates (Case, page.isRunning);
  page.posterior = readMatrix (fullfile (results, 'posterior.csv'), 1, Case);
  if page.isRunning
    page.posterior = zeros (0, numel (Case.names));
  end
  page.plan = readMatrix (fullfile (Case.folder, ...
                                    'ExperimentalPlan_DoE.csv'), 0, Case);
  page.runs = pageRuns (Case);
  page.units = regexprep ({targetInfo(Case).unit}, '^-$', '');
  page.found = foundSet (s, Case.names);
  page.reach = reachOf (page.surrogates, Case);
  page.verdict = decideCase (s.calibration, s.gap, ~isempty (page.runs) || ...
                             ~isempty (page.plan));
  % beside the reference that was calibrated the effect of a change is no fit
  isOther = ~isempty (jsonAt (s.gap, {'reference'})) && ...
            ~isempty (s.calibration);
  page.showsEffect = ~isOther && ...
                     ~isempty (jsonAt (page.verdict, {'cause', 'closed'}));
end

function Case = candidates (Case)
  try
    if isempty (Case.effects)
      Case = withEffects (Case);
    end
  catch
    % without its list of effects the diagnosis is shown all the same
  end
end

function list = readTable (file)
  list = [];
  try
    if ~isfile (file)
      return
    end
    [head, cells] = readCsvTable (file);
    numbers = num2cell (str2double (cells));
    isText = cellfun (@isnan, numbers) & ~cellfun (@isempty, cells);
    numbers(isText) = cells(isText);
    list = cell2struct (numbers, head, 2);
  catch
    list = [];
  end
end

function M = readMatrix (file, nHead, Case)
  M = zeros (0, numel (Case.names));
  try
    if isfile (file)
      M = dlmread (file, ',', nHead, 0);
    end
  catch
    M = zeros (0, numel (Case.names));
  end
  if columns (M) < numel (Case.names)
    M = zeros (0, numel (Case.names));
  end
  M = M(:, 1:numel (Case.names));       % levels stand behind
end

function surrogates = readSurrogates (Case, isRunning)
  places = {fullfile(Case.folder, 'results', 'surrogates'), ...
            fullfile(Case.folder, 'KrigingFuns')};
  if isRunning
    places = places(2);
  end
  surrogates = [];
  for k = 1:numel (places)
    surrogates = fromFolder (places{k}, Case);
    if ~isempty (surrogates)
      return
    end
  end
end

function surrogates = fromFolder (folder, Case)
  surrogates = [];
  try
    for t = 1:numel (Case.targets)
      file = fullfile (folder, sprintf ('KM_fun_%d.txt', t));
      surrogates = [surrogates, loadSurrogate(file)];
    end
    if any (cellfun (@columns, {surrogates.X}) ~= numel (Case.names))
      surrogates = [];                  % of another box
    end
  catch
    surrogates = [];
  end
end

function p = foundSet (sources, names)
  p = zeros (0, numel (names));
  for source = {'calibration', 'progress'}
    params = jsonAt (sources, {source{1}, 'params'});
    if isstruct (params) && all (isfield (params, names)) && isempty (p)
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
    P = [limits(1, :) + u .* diff(limits); s.X(isInside, :)];
    m = predictSurrogate (s, P);
    reach(t, :) = [min(m), max(m)];
  end
end

%!test
%! % a case of which nothing has been run
%! Case = newCase (standInCase (tempname ()));
%! page = pageData (Case);
%! assert (page.isRunning);
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
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (Case.folder, 's');
