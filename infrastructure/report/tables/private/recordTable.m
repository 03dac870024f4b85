% RECORDTABLE  Statement: what stands behind a result, for a dispute about it.
%
% CALL: T = recordTable (PAGE)
%
%   PAGE  see pageData
%   T     see newTable: digests of input and runs, who measured when, trials of
%         each session, rival causes and what would part them, what was not shown

function T = recordTable (page)
  T = newTable (page, 'record', 'Record of this result', ...
                {'matter', '', ''; 'what is known', '', 'words'}, ...
                [digests(page), measured(page.Case), rivals(page), ...
                 {{'what was not shown', notShown(page)}}]);
end

function list = digests (page)
  result = page.sources.calibration;
  if isempty (result)
    result = page.sources.gap;
  end
  parts = givenField (jsonAt (result, {'input'}), 'digest', struct ());
  % models that run the same program have its digest once each
  once = @(text) strjoin (unique (strsplit (char (text), ' ')), ' ');
  texts = eachOf (@(n) [n, ' ', once(parts.(n))], fieldnames (parts));
  texts = texts(~cellfun (@isempty, struct2cell (parts)'));
  list = repmat ({{'digest of the input', strjoin(texts, ', ')}}, 1, ~isempty (texts));
  for one = jsonList (result, {'input', 'models'})
    list{end + 1} = {['input of ', one{1}.name], ['sha256 ', char(one{1}.key)]};
  end
  runs = givenField (page, 'runs', []);
  if ~isempty (runs)
    text = jsonencode ({{runs.model}, {runs.name}, {runs.seed}, {runs.status}, ...
                        vertcat(runs.params), {runs.results}});
    list{end + 1} = {'digest of the runs', ...
                     [countText(numel (runs), 'run'), ', sha256 ', hash('sha256', text)]};
  end
end

% The remarks before the head of measured.csv say who, when, on which rig.
function list = measured (Case)
  words = measuredRemarks (Case.folder);
  list = repmat ({{'measured', strjoin(words, '; ')}}, 1, ~isempty (words));
  for T = Case.targets
    list = [list, trialsOf(['trials of ', T.name], T)];
    for c = 1:numel (givenField (T, 'changed', []))
      list = [list, trialsOf(sprintf ('trials of %s, %s', T.name, Case.conditions{c}), ...
                             T.changed(c))];
    end
  end
end

function list = trialsOf (label, T)
  list = {};
  n = numel (givenField (T, 'each', []));
  if n == 0
    return
  end
  text = countText (n, 'trial');
  sessions = cellstr (givenField (T, 'sessions', {}))(:)';
  sessions = sessions(~cellfun (@isempty, sessions));
  if ~isempty (sessions)
    counts = eachOf (@(s) sprintf ('%s %d', s, sum (strcmp (sessions, s))), ...
                     unique (sessions));
    text = [text, '; by session: ', strjoin(counts, ', ')];
  end
  list = {{label, text}};
end

% None where so few numbers were measured that no cause is weighed.
function list = rivals (page)
  list = {};
  gap = page.sources.gap;
  if any (strcmp (jsonAt (page.verdict, {'cause', 'code'}), {'oneNumber', 'fewNumbers'}))
    return
  end
  which = jsonAt (gap, {'which'});
  posterior = givenField (givenField (which, 'said', which), 'posterior', struct ());
  listed = [namesIn(page.verdict.cause, 'names'), {'null', 'unlisted'}];
  tests = jsonList (gap, {'next'});
  isEnough = cellfun (@(t) any (jsonAt (t, {'gain'}) >= gap.thresholds.adviseAt), tests);
  tests = tests(isEnough);
  for name = setdiff (fieldnames (posterior)', listed, 'stable')
    p = posterior.(name{1});
    parts = tests(cellfun (@(t) any (strcmp (name{1}, partsOf (t))), tests));
    text = 'no measurement that was considered decides between them';
    if ~isempty (parts)
      text = ['told apart by: ', parts{1}.test];
    end
    text = ['probability ', plainNumber(p, 'probability'), '; ', text];
    list = [list, repmat({{['rival cause ', name{1}], text}}, 1, p >= 0.02)];
  end
end

% Of what a test decides between, each cause alone.
function names = partsOf (test)
  names = strsplit (strjoin (namesIn (test, 'between'), ' + '), ' + ');
end

function text = notShown (page)
  c = page.sources.calibration;
  gap = page.sources.gap;
  misses = page.verdict.misses;
  cause = jsonAt (gap, {'howFar', 'effect'});
  isTried = ~isempty (cause) && ~isempty (jsonAt (page.verdict, {'cause', 'closed'}));
  isProved = isequal (jsonAt (gap, {'howFar', 'verifiedByDEM'}), true);
  isOpen = isnan ([misses.met]) & [misses.runs] > 0;
  parts = [listSentences({'record.open', {misses(isOpen).name}; ...
                          'record.strict', {misses([misses.isStrict]).name}; ...
                          'record.loose', namesIn(c, 'notIdentified'); ...
                          'record.unseen', ...
                          plainName(namesIn (page.verdict.cause, 'cannotSee'))}), ...
           repmat({sentence('table.noRun')}, 1, isequal (jsonAt (c, {'runs'}), 0)), ...
           listSentences({'record.surfaces', repmat({cause}, 1, isTried && ~isProved)})];
  text = strjoin ([parts, repmat({'-'}, 1, isempty (parts))], ' ');
end

%!test
%! page = situationPage ('missed, several');
%! page.sources.gap.next.between = {'drag', 'cohesion'};
%! page.sources.gap.next.gain = 1;
%! page.sources.gap.thresholds.adviseAt = 0.2;
%! page.verdict.cause.names = {'cohesion'};
%! page.runs = struct ('model', 'M', 'name', '1', 'seed', 7, 'status', 'ok', ...
%!                     'params', [1, 2], 'results', 3);
%! T = recordTable (page);
%! text = strjoin (tableText (T), "\n");
%! for part = {'input of First', 'sha256 ab', '1 run, sha256', 'rival cause drag', ...
%!             'told apart', 'not yet by DEM'}
%!   assert (! isempty (strfind (text, part{1})), [part{1}, ': ', text]);
%! end

% SPDX-License-Identifier: GPL-3.0-only
