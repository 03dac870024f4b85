% STATEMENTTABLES  All that the report says in tables, by name.
%
% CALL: TABLES = statementTables (PAGE [, NAMES])
%
%   PAGE    see shownResult, or pageData
%   NAMES   cellstr of those that are wanted (all)
%   TABLES  struct of newTable; [], or without rows, where there is nothing to say
%
% Console, page and results/tables/*.csv show these and make none of their own.

function tables = statementTables (page, names)
  makers = struct ('targets', @targetsTable, 'parameters', @parametersTable, ...
                   'sensitivity', @sensitivityTable, 'levels', @levelsTable, ...
                   'where', @whereTable, 'causes', @causesTable, ...
                   'howfar', @howFarTable, ...
                   'beforeafter', @(page) nthargout (2, @howFarTable, page), ...
                   'next', @nextTable, 'change', @changeTable, ...
                   'conditions', @(page) nthargout (2, @changeTable, page), ...
                   'runs', @runsTable, 'failures', @failuresTable, ...
                   'settings', @settingsTable, 'record', @recordTable);
  if nargin < 2
    names = fieldnames (makers)';
  end
  tables = struct ();
  for name = names
    tables.(name{1}) = makers.(name{1}) (page);
  end
end

% Which parameter drives which result, a row a result, as there are more of them.
function T = sensitivityTable (page)
  T = [];
  names = page.Case.names;
  share = jsonAt (page.sources.calibration, {'sensitivity'});
  if isempty (share) || ~all (isfield (share, names))
    return
  end
  cellOf = @(name, t) struct ('value', {{'calibration', 'sensitivity', name, t}}, 'class', ...
                              repmat ('z2', 1, share.(name)(t) >= 0.3));
  row = @(t) [{targetCell(page, page.Case.targets(t))}, ...
              eachOf(@(name) cellOf (name, t), names)];
  T = newTable (page, 'sensitivity', ...
                'Which parameter drives which result: share of its variance within the limits', ...
                [{'result', '', 'name'}; names(:), ...
                 repmat({'', 'probability'}, numel (names), 1)], ...
                eachOf (row, shownTargets (page.Case)));
end

% What each level of Input.coarse tells and costs; no rows for a case without levels.
function T = levelsTable (page)
  levels = jsonList (page.sources.calibration, {'levels'});
  n = numel (levels);
  shifts = [eachOf(@(level) levelLine (level, page.Case.targets), levels(1:n - 1)), ...
            {'the level that counts'}];
  row = @(k) {namedValues({page.Case.coarse.variable}, levels{k}.value), ...
              {'calibration', 'levels', k, 'runs'}, ...
              {'calibration', 'levels', k, 'seconds'}, shifts{k}};
  T = newTable (page, 'levels', ...
                'Runs at each level, and what it does to the results with these values', ...
                {'level', '', ''; 'runs', '', 'count'; 'a run', 'core-s', 'plain'; ...
                 'shift', '', 'words'}, eachOf (row, 1:n));
end

% The shift of each target with its standard deviation, of a curve the root mean square;
% at most four targets, the most shifted first. LEVEL  element of levels, see
% newCalibration; TARGETS  Case.targets
function text = levelLine (level, targets)
  kept = find (~level.dropped(:)');
  [groups, ~, isJoint] = requirementsOf (targets, kept);
  parts = {};
  scalars = [groups{~isJoint}];
  share = abs (level.shift(scalars)(:)') ./ [targets(scalars).tol];
  [~, order] = sort (share, 'descend');
  for t = scalars(order(1:min (end, 4)))
    parts{end + 1} = sprintf ('%s %+.3g +- %.2g', targets(t).name, ...
                              level.shift(t), level.shiftSd(t));
  end
  for group = groups(isJoint)
    rms = sqrt (mean (level.shift(group{1}).^2));
    parts{end + 1} = sprintf ('%s rms %.3g', targets(group{1}(1)).series, rms);
  end
  n = sum (level.dropped);
  if n > 0
    parts{end + 1} = sprintf ('dropped for %d of %s', n, ...
                              countText (numel (targets), 'target'));
  end
  text = strjoin (parts, '; ');
end

% What can be measured next, and what it would tell: ten tests at most.
function T = nextTable (page)
  tests = jsonList (page.sources.gap, {'next'});
  row = @(k) {nthargout(2, @nextText, tests{k}), {'gap', 'next', k, 'gain'}, ...
              {'gap', 'next', k, 'cost'}};
  notes = {sentence('table.nextLittle'), sentence('table.next')};
  isLittle = isequal (jsonNumber (tests, {1, 'gain'}) < ...
                      jsonAt (page.sources.gap, {'thresholds', 'adviseAt'}), true);
  if ~isempty (unsureTests (page.sources.gap))
    notes{1} = sentence ('table.nextUnsure');
  end
  T = newTable (page, 'next', 'What can be measured next, the best first', ...
                {'test', '', 'words'; 'gain', 'bit', 'probability'; 'cost', '', 'plain'}, ...
                eachOf (row, 1:min (numel (tests), 10)), notes(2 - isLittle:end));
end

% Why runs failed, the most frequent reason first, 20 at most.
function T = failuresTable (page)
  bad = givenField (page, 'runs', struct ('status', {}, 'message', {}));
  bad = bad(~ismember ({bad.status}, {'ok', 'not ended'}));
  reasons = strcat ({bad.status}, {': '}, {bad.message});
  [kinds, first, number] = unique (reasons, 'first');
  count = accumarray (number(:), 1, [numel(kinds), 1]);
  [~, order] = sort (-count);
  row = @(k) {kinds{k}, count(k), [bad(first(k)).model, '/', bad(first(k)).name]};
  T = newTable (page, 'failures', 'Why runs failed, the most frequent reason first', ...
                {'reason', '', 'words'; 'runs', '', 'count'; 'first of them', '', ''}, ...
                eachOf (row, order(1:min (end, 20))));
end

% What the case was run with: models with the key of their input, fixed model variables,
% options, versions.
function T = settingsTable (page)
  Case = page.Case;
  c = page.sources.calibration;
  numbers = cellfun (@(x) isnumeric (x) && isscalar (x), struct2cell (Case.options));
  texts = cellfun (@ischar, struct2cell (Case.options));
  names = fieldnames (Case.options);
  versions = {{'version', 'DEcalioc', char(jsonAt (c, {'version'}))}, ...
              {'version', 'Octave', OCTAVE_VERSION()}};
  T = newTable (page, 'settings', 'Models, fixed model variables, options, versions', ...
                {'kind', '', ''; 'name', '', ''; 'value', '', ''}, ...
                [eachOf(@(k) modelRow (Case, c, k), 1:numel (Case.models)), ...
                 eachOf(@(n) {'model variable', n, Case.modelVars.(n)}, ...
                        fieldnames (Case.modelVars)), ...
                 eachOf(@(n) {'option', n, optionText(Case.options.(n))}, ...
                        names(numbers | texts)), ...
                 versions(1 + ~ischar (jsonAt (c, {'version'})):end)]);
end

function cells = modelRow (Case, c, k)
  model = Case.models(k);
  key = char (jsonAt (c, {'input', 'models', k, 'key'}));
  % no path of this machine: the page is mailed
  folder = strrep (strrep (model.folder, Case.folder, 'case'), Case.root, 'DEcalioc');
  folder = [folder, repmat('none: imported runs', 1, isempty (folder))];
  cells = {'model', model.name, sprintf('%d CPU, %s, input %s', model.cpu, folder, ...
                                        key(1:min (end, 16)))};
end

function text = optionText (value)
  text = value;
  if isequal (value, Inf)
    text = sentence ('table.noLimit');
  elseif isnumeric (value)
    text = sprintf ('%g', value);
  end
end

%!function T = one (name, page)
%!  T = statementTables (page, {name}).(name);
%!endfunction
%!test
%! page = situationPage ('missed, named');
%! tables = statementTables (page);
%! assert (all (isfield (tables, {'targets', 'causes', 'settings'})));
%! assert (isempty (tables.change));
%! assert (fieldnames (statementTables (page, {'where'})), {'where'});
%!test
%! T = one ('sensitivity', situationPage ('met'));
%! assert (size (T.cells), [3, 3]);
%! assert ({T.cells{3, 2}.value, T.cells{3, 2}.class}, {0.5, 'z2'});
%! assert (isempty (one ('sensitivity', situationPage ('nothing'))));
%!test
%! page = situationPage ('met');
%! page.Case.coarse = struct ('variable', 'size');
%! page.Case.targets = struct ('name', {'a', 'b', 'c1', 'c2'}, 'tol', 1, ...
%!                             'curve', {0, 0, 1, 1}, 'series', {'', '', 'c', 'c'});
%! level = struct ('value', {2, 1}, 'runs', {5, 7}, 'seconds', {1, 8}, ...
%!                 'shift', {[0.1, -2, 3, 4], []}, 'shiftSd', [1, 1, 1, 1] / 4, ...
%!                 'dropped', false (1, 4));
%! page.sources.calibration.levels = level;
%! T = one ('levels', page);
%! assert ({T.cells{1, 1}.value, T.cells{1, 2}.value}, {'size = 2', 5});
%! assert (T.cells{1, 4}.value, 'b -2 +- 0.25; a +0.1 +- 0.25; c rms 3.54');
%! assert (T.cells{2, 4}.value, 'the level that counts');
%! % as it comes from a file; the order is that of shift over tolerance
%! page.Case.targets(1).tol = 0.01;
%! page.sources.calibration.levels(1).shift = level(1).shift';
%! assert (one ('levels', page).cells{1, 4}.value, ...
%!         'a +0.1 +- 0.25; b -2 +- 0.25; c rms 3.54');
%! page.sources.calibration.levels(1).dropped(1) = true;
%! assert (one ('levels', page).cells{1, 4}.value, ...
%!         'b -2 +- 0.25; c rms 3.54; dropped for 1 of 4 targets');
%! assert (isempty (one ('levels', situationPage ('met')).cells));
%!test
%! T = one ('next', situationPage ('missed, named'));
%! assert (T.cells{1, 1}.value, 'measure First once more');
%! assert (T.notes{1}, sentence ('table.nextLittle'));
%! page = situationPage ('missed, named');
%! next = struct ('test', {'measure First once more', 'measure Bin'}, 'trials', 1, 'gain', ...
%!                {0.1, 1.2}, 'cost', 1, 'between', {{}}, 'sure', {true, false});
%! page.sources.gap.next = next;
%! assert (one ('next', page).notes{1}, sentence ('table.nextUnsure'));
%!test
%! page.runs = struct ('model', 'M', 'name', {'1', '2', '3', '4'}, 'status', ...
%!                     {'failed', 'failed', 'ok', 'timeout'}, 'message', {'x', 'x', '', 'y'});
%! page.sources = [];
%! T = one ('failures', page);
%! assert (cellfun (@(c) c.value, T.cells(:, 2))', [2, 1]);
%! assert (T.cells{1, 3}.value, 'M/1');
%!test
%! T = one ('settings', situationPage ('met'));
%! names = cellfun (@(c) c.value, T.cells(:, 2)', 'UniformOutput', false);
%! assert (all (ismember ({'First', 'seed', 'Octave'}, names)));
%! assert (! isempty (strfind (T.cells{1, 3}.value, 'case/DEMmodels/First, input ab')));

% SPDX-License-Identifier: GPL-3.0-only
