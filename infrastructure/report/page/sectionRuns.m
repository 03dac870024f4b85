% SECTIONRUNS  Part of the report: when what was run, and what failed, and why.
%
% CALL: [TITLE, HTML] = sectionRuns (PAGE), see writePage and pageData

function [title, html] = sectionRuns (page)
  title = 'Runs and failures';
  html = '';
  if isempty (page.runs)
    return
  end
  key = htmlKey ({'box', 'blue', 'ended well'; ...
                  'box', 'red', 'failed, too long, or no valid result'; ...
                  'box', 'grey', 'not ended'});
  html = [htmlFigures(timeline (page.runs), key, 'wide'), counts(page), ...
          levels(page), failures(page.runs)];
end

% What each level of Input.coarse has told and cost.
function html = levels (page)
  html = '';
  known = jsonAt (page, {'sources', 'calibration', 'levels'});
  if isempty (known)
    return
  end
  names = {page.Case.coarse.variable};
  cells = cell (numel (known), 4);
  for k = 1:numel (known)
    own = known(k);
    text = namedValues (names, own.value);
    what = 'the level that counts';
    if k < numel (known)
      what = levelLine (own, page.Case.targets);
    end
    cells(k, :) = {htmlText(text), sprintf('%d', own.runs), ...
                   numberText(own.seconds, 'plain'), ...
                   ['<span class="words">', htmlText(what), '</span>']};
  end
  html = ['<h3>Levels</h3>', ...
          htmlTable(['Runs at each level, and what it does to the ', ...
                     'responses at the set that was found'], ...
                    {'level', 'runs', 'core-seconds a run', 'shift'}, cells)];
end

function f = timeline (runs)
  started = [runs.started];
  known = isfinite (started);
  f = [];
  if ~any (known)
    return
  end
  zero = min (started(known));
  runs = runs(known);
  from = [runs.started] - zero;
  lasted = [runs.seconds];
  lasted(~isfinite (lasted)) = 0;
  to = from + lasted;
  [factor, unit] = timeUnit (max ([to, 1]));
  lane = lanes (from, to);
  alt = sprintf ('%d runs over %.3g %s, %d of them did not end well', ...
                 numel (runs), max ([to, 0]) * factor, unit, ...
                 sum (~strcmp ({runs.status}, 'ok')));
  f = newFigure ('Timeline, a bar for each run', ...
                 sprintf ('%s since the first start', unit), '', alt);
  f.size = [700, 100 + 14 * min(max ([lane, 1]), 16)];
  f.ylim = [0.3, max([lane, 1]) + 0.7];
  least = 0.002 * max ([to, 1]);
  M = [from(:), lane(:), from(:), max(to(:), from(:) + least), ...
       lane(:) - 0.4, lane(:) + 0.4];
  M(:, [1, 3, 4]) = M(:, [1, 3, 4]) * factor;
  isOk = strcmp ({runs.status}, 'ok');
  isOpen = strcmp ({runs.status}, 'not ended');
  f = addLayer (f, 'box', M(isOk, :), 'blue');
  f = addLayer (f, 'box', M(~isOk & ~isOpen, :), 'red');
  f = addLayer (f, 'box', M(isOpen, :), 'grey');
  f.xlim = [0, max([max(M(:, 4)), factor])];
end

function [factor, unit] = timeUnit (seconds)
  factor = 1;
  unit = 'seconds';
  if seconds > 7200
    factor = 1 / 3600;
    unit = 'hours';
  elseif seconds > 120
    factor = 1 / 60;
    unit = 'minutes';
  end
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
  runs = page.runs;
  models = unique ({runs.model});
  states = {'ok', 'failed', 'timeout', 'invalid', 'not ended'};
  cells = cell (numel (models), numel (states) + 2);
  for k = 1:numel (models)
    mine = strcmp ({runs.model}, models{k});
    cells{k, 1} = htmlText (models{k});
    for i = 1:numel (states)
      cells{k, i + 1} = sprintf ('%d', sum (mine & strcmp ({runs.status}, ...
                                                           states{i})));
    end
    seconds = [runs(mine & strcmp ({runs.status}, 'ok')).seconds];
    seconds = seconds(isfinite (seconds));
    cells{k, end} = '&ndash;';
    if ~isempty (seconds)
      cells{k, end} = numberText (median (seconds), 'plain');
    end
  end
  html = [htmlTable('Runs in the store', [{'model'}, states, ...
                                          {'median time (s)'}], cells), ...
          '<p>', htmlText(libraryLine (page.Case)), '</p>', ...
          '<p>Every run is in <code>results/runTable.csv</code>.</p>'];
end

function html = failures (runs)
  bad = runs(~ismember ({runs.status}, {'ok', 'not ended'}));
  if isempty (bad)
    html = '<p>No run failed.</p>';
    return
  end
  reasons = arrayfun (@(r) [r.status, ': ', r.message], bad, ...
                      'UniformOutput', false);
  [kinds, ~, number] = unique (reasons);
  number = number(:)';
  count = arrayfun (@(k) sum (number == k), 1:numel (kinds));
  [~, order] = sort (-count);
  order = order(1:min (end, 20));
  cells = cell (numel (order), 3);
  for i = 1:numel (order)
    k = order(i);
    mine = bad(number == k);
    cells(i, :) = {['<span class="words">', htmlText(kinds{k}), '</span>'], ...
                   sprintf('%d', count(k)), ...
                   htmlText(sprintf ('%s/%s', mine(1).model, mine(1).name))};
  end
  html = ['<h3>Why runs failed</h3>', ...
          htmlTable('Reasons, the most frequent first', ...
                    {'reason', 'runs', 'first of them'}, cells)];
end

%!shared Case
%! Case.folder = tempname ();
%!test
%! runs = struct ('model', 'M', 'name', {'1', '2', '3'}, 'status', ...
%!                {'ok', 'failed', 'not ended'}, 'message', ...
%!                {'', 'exit status 3; ERROR <x>', ''}, 'seconds', ...
%!                {10, 5, NaN}, 'started', {1000, 1001, 1012});
%! [~, html] = sectionRuns (struct ('runs', runs, 'Case', Case));
%! assert (! isempty (strfind (html, 'ERROR &lt;x&gt;')));
%! assert (! isempty (strfind (html, '3 runs over 12 seconds, 2')));
%!test
%! % the first runs are under way: none has a time yet; nor a start
%! runs = struct ('model', 'M', 'name', '1', 'status', 'not ended', ...
%!                'message', '', 'seconds', NaN, 'started', {1000, NaN});
%! [~, html] = sectionRuns (struct ('runs', runs, 'Case', Case));
%! assert (! isempty (strfind (html, '1 runs over')));
%! runs = runs(2);
%! [~, html] = sectionRuns (struct ('runs', runs, 'Case', Case));
%! assert (! isempty (strfind (html, 'No run failed')));
