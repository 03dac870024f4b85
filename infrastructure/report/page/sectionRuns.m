% SECTIONRUNS  Parts of the report: when what was run, and what failed, and why;
% settings, versions, how to repeat it.
%
% CALL: LIST = sectionRuns (), see writePage

function list = sectionRuns ()
  list = {'sectionruns', 'Runs and failures', @allRuns, {'runs'}; ...
          'sectionsettings', 'Settings and how to repeat it', @settings, {}};
end

function html = allRuns (page)
  key = {'box', 'blue', 'ended well'; ...
         'box', 'red', 'failed, too long, or no valid result'; ...
         'box', 'grey', 'not ended'};
  html = [htmlFigures(timeline (page.runs), key, 'wide'), counts(page), ...
          levels(page), failures(page.runs)];
end

function f = timeline (runs)
  runs = runs(isfinite ([runs.started]));
  f = [];
  if isempty (runs)
    return
  end
  from = [runs.started] - min ([runs.started]);
  lasted = [runs.seconds];
  lasted(~isfinite (lasted)) = 0;
  to = from + lasted;
  last = max ([to, 1]);
  units = {1, 'seconds'; 1 / 60, 'minutes'; 1 / 3600, 'hours'};
  [factor, unit] = units{1 + (last > 120) + (last > 7200), :};
  lane = lanes (from, to);
  isOk = strcmp ({runs.status}, 'ok');
  isOpen = strcmp ({runs.status}, 'not ended');
  alt = sprintf ('%d runs over %.3g %s, %d of them did not end well', ...
                 numel (runs), max (to) * factor, unit, sum (~isOk));
  M = [factor * from', lane', factor * from', ...
       factor * max(to, from + 0.002 * last)', lane' - 0.4, lane' + 0.4];
  f = newFigure ('Timeline, a bar for each run', ...
                 [unit, ' since the first start'], '', alt, ...
                 {'box', M(isOk, :), 'blue'; ...
                  'box', M(~isOk & ~isOpen, :), 'red'; ...
                  'box', M(isOpen, :), 'grey'});
  f.size = [700, 100 + 14 * min(max (lane), 16)];
  f.xlim = [0, max([M(:, 4); factor])];
  f.ylim = [0.3, max(lane) + 0.7];
end

% The first lane that is free when a run starts.
function lane = lanes (from, to)
  busy = [];
  lane = ones (size (from));
  for k = 1:numel (from)
    free = find (busy <= from(k) + 0.3, 1);
    if isempty (free)
      free = numel (busy) + 1;
    end
    lane(k) = free;
    busy(free) = to(k);
  end
end

function html = counts (page)
  models = unique ({page.runs.model});
  states = {'ok', 'failed', 'timeout', 'invalid', 'not ended'};
  html = [htmlTable('Runs in the store', [{'model'}, states, ...
                                          {'median time (s)'}], ...
                    @(k) countRow (page.runs, models{k}, states), ...
                    numel (models)), ...
          '<p>', htmlText(libraryLine (page.Case)), '</p>', ...
          '<p>Every run is in <code>results/runTable.csv</code>.</p>'];
end

function cells = countRow (runs, model, states)
  runs = runs(strcmp ({runs.model}, model));
  numbers = cellfun (@(state) sprintf ('%d', sum (strcmp ({runs.status}, ...
                                                          state))), ...
                     states, 'UniformOutput', false);
  seconds = [runs(strcmp ({runs.status}, 'ok')).seconds];
  middle = seconds(isfinite (seconds));
  if ~isempty (middle)
    middle = median (middle);
  end
  cells = [{htmlText(model)}, numbers, {numberText(middle)}];
end

% What each level of Input.coarse has told and cost.
function html = levels (page)
  html = '';
  known = jsonAt (page.sources.calibration, {'levels'});
  if isempty (known)
    return
  end
  what = arrayfun (@(level) levelLine (level, page.Case.targets), known(:)', ...
                   'UniformOutput', false);
  what{end} = 'the level that counts';
  row = @(k) {htmlText(namedValues ({page.Case.coarse.variable}, ...
                                    known(k).value)), ...
              sprintf('%d', known(k).runs), numberText(known(k).seconds), ...
              ['<span class="words">', htmlText(what{k}), '</span>']};
  html = ['<h3>Levels</h3>', ...
          htmlTable(['Runs at each level, and what it does to the ', ...
                     'responses at the set that was found'], ...
                    {'level', 'runs', 'core-seconds a run', 'shift'}, row, ...
                    numel (known))];
end

function html = failures (runs)
  bad = runs(~ismember ({runs.status}, {'ok', 'not ended'}));
  if isempty (bad)
    html = '<p>No run failed.</p>';
    return
  end
  reasons = strcat ({bad.status}, {': '}, {bad.message});
  [kinds, first, number] = unique (reasons, 'first');
  count = accumarray (number(:), 1);
  [~, order] = sort (-count);
  row = @(k) {['<span class="words">', htmlText(kinds{k}), '</span>'], ...
              sprintf('%d', count(k)), ...
              htmlText([bad(first(k)).model, '/', bad(first(k)).name])};
  html = ['<h3>Why runs failed</h3>', ...
          htmlTable('Reasons, the most frequent first', ...
                    {'reason', 'runs', 'first of them'}, ...
                    @(i) row (order(i)), min (numel (order), 20))];
end

function html = settings (page)
  word = 'run';
  if ~isempty (page.sources.gap) && isempty (page.sources.calibration)
    word = 'diagnose';
  end
  warnings = strcat ('<li>', ...
                     htmlText (namesIn (page.sources.calibration, ...
                                        'warnings')), '</li>');
  if ~isempty (warnings)
    warnings = [{'<h3>Warnings</h3><ul>'}, warnings, {'</ul>'}];
  end
  variables = page.Case.modelVars;
  names = fieldnames (variables);
  html = ['<p>The same case with the same seed asks for the same runs ', ...
          'again, and takes those in the store: <code>decalioc ', word, ...
          '</code> in the case folder.</p>', warnings{:}, ...
          htmlTable('Models (key: hash of input files, CPUs, program)', ...
                    {'model', 'CPUs a run', 'folder', 'key'}, ...
                    @(k) modelRow (page, k), numel (page.Case.models)), ...
          htmlTable('Model variables that are fixed', ...
                    {'variable', 'value'}, ...
                    @(k) {htmlText(names{k}), ...
                          numberText(variables.(names{k}))}, ...
                    numel (names)), ...
          optionTable(page), fileList(page)];
end

function cells = modelRow (page, k)
  model = page.Case.models(k);
  key = jsonAt (page.sources.calibration, {'input', 'models', k, 'key'});
  if isempty (key)
    key = '-';
  end
  % no path of this machine: the page is mailed
  folder = strrep (model.folder, page.Case.folder, 'case');
  folder = strrep (folder, page.Case.root, 'DEcalioc');
  if isempty (folder)
    folder = 'none: imported runs';
  end
  cells = {htmlText(model.name), sprintf('%d', model.cpu), ...
           ['<code>', htmlText(folder), '</code>'], ...
           ['<code>', key(1:min (end, 16)), '</code>']};
end

function html = optionTable (page)
  cells = cell (0, 2);
  for name = fieldnames (page.Case.options)'
    value = page.Case.options.(name{1});
    if isnumeric (value) && isscalar (value)
      value = strrep (sprintf ('%g', value), 'Inf', 'no limit');
    end
    if ischar (value)
      cells(end + 1, :) = {name{1}, htmlText(value)};
    end
  end
  version = jsonAt (page.sources.calibration, {'version'});
  if ischar (version)
    cells(end + 1, :) = {'version of DEcalioc', htmlText(version)};
  end
  cells(end + 1, :) = {'Octave', htmlText(OCTAVE_VERSION ())};
  html = htmlTable ('Options', {'option', 'value'}, cells);
end

function html = fileList (page)
  files = {'results/calibration.json', 'the result for other programs'; ...
           'results/calibrated.head', ...
           'lines of a data.head with the calibrated parameters'; ...
           'results/posterior.csv', 'a sample of the sets that fit'; ...
           'results/sensitivity.csv', ...
           'share of each response that each parameter makes'; ...
           'results/correlation.csv', 'of the parameters'; ...
           'results/runTable.csv', 'every run'; ...
           'gap/gap.json', 'the diagnosis for other programs'; ...
           'gap/calibrated.head', ...
           'parameters fitted together with the effect'; ...
           'Octave_logfile.txt', 'all that was said'};
  isThere = cellfun (@(file) isfile (fullfile (page.Case.folder, file)), ...
                     files(:, 1));
  items = strcat ('<li><code>', files(isThere, 1), {'</code>: '}, ...
                  files(isThere, 2), '</li>');
  html = '';
  if ~isempty (items)
    html = ['<h3>Files in the case folder</h3><ul>', items{:}, '</ul>'];
  end
end

%!test
%! one = @(status, message, seconds, started) struct ( ...
%!   'model', 'M', 'name', '1', 'status', status, 'message', message, ...
%!   'seconds', seconds, 'started', started);
%! html = @(runs) sectionRuns (){1, 3} (struct ( ...
%!   'runs', runs, 'Case', struct ('folder', tempname ()), ...
%!   'sources', struct ('calibration', [])));
%! runs = [one('ok', '', 10, 1000), ...
%!         one('failed', 'exit status 3; ERROR <x>', 5, 1001), ...
%!         one('not ended', '', NaN, 1012)];
%! assert (! isempty (strfind (html (runs), 'ERROR &lt;x&gt;')));
%! assert (! isempty (strfind (html (runs), '3 runs over 12 seconds, 2')));
%! % the first runs are under way: none has a time yet; nor a start
%! runs = [one('not ended', '', NaN, 1000), one('not ended', '', NaN, NaN)];
%! assert (! isempty (strfind (html (runs), '1 runs over')));
%! assert (! isempty (strfind (html (runs(2)), 'No run failed')));
