% RECORDTABLE  Statement: what stands behind a result, for a dispute about it.
%
% CALL: T = recordTable (PAGE)
%
%   PAGE  see pageData
%   T     see newTable: digests of input and runs, who measured when, trials of
%         each session, rival causes and what would part them, what was not shown

function T = recordTable (page)
  list = [digests(page); measured(page.Case); rivals(page); notShown(page)];
  T = newTable (page, 'record', 'Record of this result', ...
                {'matter', '', ''; 'what is known', '', 'words'}, list);
end

function list = digests (page)
  list = cell (0, 2);
  result = page.sources.calibration;
  if isempty (result)
    result = page.sources.gap;
  end
  parts = jsonAt (result, {'input', 'digest'});
  if isstruct (parts)
    texts = cellfun (@(n) [n, ' ', char(parts.(n))], fieldnames (parts)', ...
                     'UniformOutput', false);
    texts = texts(~cellfun (@isempty, struct2cell (parts)'));
    list(end + 1, :) = {'digest of the input', strjoin(texts, ', ')};
  end
  models = jsonAt (result, {'input', 'models'});
  for k = 1:numel (models)
    one = jsonAt (models, {k});
    list(end + 1, :) = {['input of ', one.name], ['sha256 ', char(one.key)]};
  end
  runs = givenField (page, 'runs', []);
  if ~isempty (runs)
    text = jsonencode ({{runs.model}, {runs.name}, {runs.seed}, {runs.status}, ...
                        vertcat(runs.params), {runs.results}});
    list(end + 1, :) = {'digest of the runs', ...
                        sprintf('%d runs, sha256 %s', numel (runs), hash ('sha256', text))};
  end
end

% The remarks before the head of measured.csv say who, when, on which rig.
function list = measured (Case)
  list = cell (0, 2);
  words = measuredRemarks (Case.folder);
  if ~isempty (words)
    list(end + 1, :) = {'measured', strjoin(words, '; ')};
  end
  for T = Case.targets
    n = numel (givenField (T, 'each', []));
    sessions = cellstr (givenField (T, 'sessions', {}))(:)';
    sessions = sessions(~cellfun (@isempty, sessions));
    if n > 0 || ~isempty (sessions)
      text = sprintf ('%d trials', n);
      if ~isempty (sessions)
        names = unique (sessions);
        counts = cellfun (@(s) sprintf ('%s %d', s, sum (strcmp (sessions, s))), names, ...
                          'UniformOutput', false);
        text = [text, '; by session: ', strjoin(counts, ', ')];
      end
      list(end + 1, :) = {['trials of ', T.name], text};
    end
  end
end

function list = rivals (page)
  list = cell (0, 2);
  gap = page.sources.gap;
  effects = namesIn (jsonAt (gap, {'which'}), 'effects');
  posterior = jsonAt (gap, {'which', 'posterior'});
  if isempty (posterior)
    return
  end
  names = setdiff (fieldnames (posterior)', [effects, {'null', 'unlisted'}], 'stable');
  p = cellfun (@(n) posterior.(n), names);
  names = names(p >= 0.02);
  p = p(p >= 0.02);
  tests = jsonAt (gap, {'next'});
  for k = 1:numel (names)
    text = ['probability ', plainNumber(p(k), 'probability')];
    parts = arrayfun (@(i) any (strcmp (names{k}, namesIn (jsonAt (tests, {i}), 'between'))), ...
                      1:numel (tests));
    if any (parts)
      text = [text, '; told apart by: ', jsonAt(tests, {find(parts, 1), 'test'})];
    else
      text = [text, '; no test that was looked at tells it apart'];
    end
    list(end + 1, :) = {['rival cause ', names{k}], text};
  end
end

function list = notShown (page)
  parts = {};
  c = page.sources.calibration;
  gap = page.sources.gap;
  v = page.verdict;
  codes = {'record.open', {v.misses(isnan ([v.misses.met]) & [v.misses.runs] > 0).name}; ...
           'record.strict', {v.misses([v.misses.isStrict]).name}; ...
           'record.loose', namesIn(c, 'notIdentified'); ...
           'record.unseen', plainName(namesIn (jsonAt (gap, {'which'}), 'cannotSee'))};
  for one = codes(~cellfun (@isempty, codes(:, 2)), :)'
    parts{end + 1} = sentence (one{1}, struct ('names', {one{2}}));
  end
  if isequal (jsonAt (c, {'runs'}), 0)
    parts{end + 1} = sentence ('table.noRun');
  end
  if ~isempty (jsonAt (gap, {'howFar', 'effect'})) && ...
     ~isequal (jsonAt (gap, {'howFar', 'verifiedByDEM'}), true)
    parts{end + 1} = sentence ('record.surfaces', struct ('cause', gap.howFar.effect));
  end
  if isempty (parts)
    parts = {'-'};
  end
  list = {'what was not shown', strjoin(parts, ' ')};
end

%!test
%! page = situationPage ('missed, several');
%! page.sources.gap.next.between = {'drag', 'cohesion'};
%! page.sources.gap.which.effects = {'cohesion'};
%! page.runs = struct ('model', 'M', 'name', '1', 'seed', 7, 'status', 'ok', ...
%!                     'params', [1, 2], 'results', 3);
%! T = recordTable (page);
%! text = strjoin (tableText (T), "\n");
%! for part = {'input of First', 'sha256 ab', '1 runs, sha256', 'rival cause drag', ...
%!             'told apart', 'not yet by DEM'}
%!   assert (! isempty (strfind (text, part{1})), [part{1}, ': ', text]);
%! end
