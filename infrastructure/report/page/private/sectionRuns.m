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
  none = repmat ('<p>No run failed.</p>', 1, isempty (page.tables.failures.cells));
  html = [htmlFigures(timeline (page.runs), key, 'wide'), tableHtml(page.tables.runs), ...
          '<p>', htmlText(libraryLine (page.Case)), '</p>', ...
          '<p>Every run is in <code>results/runTable.csv</code>.</p>', ...
          tableHtml(page.tables.levels), tableHtml(page.tables.failures), none];
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
  [factor, unit] = deal (1, 'seconds');
  if last > 7200
    [factor, unit] = deal (1 / 3600, 'hours');
  elseif last > 120
    [factor, unit] = deal (1 / 60, 'minutes');
  end
  lane = lanes (from, to);
  isOk = strcmp ({runs.status}, 'ok');
  isOpen = strcmp ({runs.status}, 'not ended');
  alt = sprintf ('%s over %.3g %s, %d of them did not end well', ...
                 countText (numel (runs), 'run'), max (to) * factor, unit, sum (~isOk));
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

function html = settings (page)
  isGap = ~isempty (page.sources.gap) && isempty (page.sources.calibration);
  notes = strcat ('<li>', htmlText (namesIn (page.sources.calibration, 'warnings')), '</li>');
  html = ['<p>The same case with the same seed asks for the same runs ', ...
          'again, and takes those in the store: <code>decalioc ', ...
          merge(isGap, 'diagnose', 'run'), ...
          '</code> in the case folder.</p>', titled('Notes', notes), ...
          tableHtml(page.tables.settings), fileList(page)];
end

function html = titled (title, items)
  html = repmat (['<h3>', title, '</h3><ul>', items{:}, '</ul>'], 1, ~isempty (items));
end

function html = fileList (page)
  files = {'results/calibration.json', 'the result for other programs'; ...
           'results/calibrated.head', ...
           'lines of a data.head with the calibrated parameters'; ...
           'results/posterior.csv', 'a sample of the values that fit'; ...
           'results/sensitivity.csv', ...
           'share of each response that each parameter makes'; ...
           'results/correlation.csv', 'of the parameters'; ...
           'results/runTable.csv', 'every run'; ...
           'gap/gap.json', 'the diagnosis for other programs'; ...
           'gap/calibrated.head', ...
           'parameters fitted together with the effect'; ...
           'results/notes.txt', 'notes on the result'; ...
           'results/tables', 'each table as CSV'; 'results/figures', 'each figure as SVG'; ...
           'Octave_logfile.txt', 'complete log'};
  isThere = cellfun (@(file) exist (fullfile (page.Case.folder, file), 'file') > 0, ...
                     files(:, 1));
  items = strcat ('<li><code>', files(isThere, 1), {'</code>: '}, ...
                  files(isThere, 2), '</li>');
  html = titled ('Files in the case folder', items);
end

%!function page = withTables (runs)
%!  page = struct ('runs', runs, 'Case', struct ('folder', tempname ()), ...
%!                 'sources', struct ('calibration', []));
%!  page.tables = statementTables (page, {'runs', 'failures', 'levels'});
%!endfunction
%!test
%! one = @(status, message, seconds, started) struct ( ...
%!   'model', 'M', 'name', '1', 'status', status, 'message', message, ...
%!   'seconds', seconds, 'started', started);
%! html = @(runs) sectionRuns (){1, 3} (withTables (runs));
%! runs = [one('ok', '', 10, 1000), ...
%!         one('failed', 'exit status 3; ERROR <x>', 5, 1001), ...
%!         one('not ended', '', NaN, 1012)];
%! assert (! isempty (strfind (html (runs), 'ERROR &lt;x&gt;')));
%! assert (! isempty (strfind (html (runs), '3 runs over 12 seconds, 2')));
%! % the first runs are under way: none has a time yet; nor a start
%! runs = [one('not ended', '', NaN, 1000), one('not ended', '', NaN, NaN)];
%! assert (! isempty (strfind (html (runs), '1 run over')));
%! assert (! isempty (strfind (html (runs(2)), 'No run failed')));

% SPDX-License-Identifier: GPL-3.0-only
