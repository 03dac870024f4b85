% WHERETABLE  Statement: where the measurements are missed, or have changed.
%
% CALL: T = whereTable (PAGE)
%
%   PAGE  see shownResult
%   T     see newTable, the largest deviation first; no rows without a diagnosis

function T = whereTable (page)
  where = jsonAt (page.sources.gap, {'where'});
  targets = jsonList (where, {'targets'});
  [~, order] = sort (-abs (cellfun (@(t) jsonNumber (t, {fieldOf(t)}), targets)));
  means = merge (page.isChange, 'without a change', 'simulated');
  titles = {'Where the measurements are missed', 'Where the measurements have changed'};
  columns = {'result', '', 'name'; 'measured', '', 'plain'; ...
             means, '', 'plain'; 'difference +- noise', '', 'change'; ...
             merge(page.isChange, 'times the noise', 'deviation (sd)'), '', 'z'; ...
             'p', '', 'p'; 'parameters cannot hide', '', 'percent'; ...
             'remark', '', 'words'};
  columns{7, 4} = 'page';
  isShown = [true(1, 3), page.isChange, true(1, 4)];
  T = newTable (page, 'where', [titles{1 + page.isChange}, ', the largest deviation first'], ...
                columns(isShown, :), eachOf (@(t) rowOf (page, targets{t}, t)(isShown), order), ...
                notesOf (where, page.isChange));
end

function cells = rowOf (page, target, t)
  at = @(field) {'gap', 'where', 'targets', t, field};
  significance = page.sources.gap.thresholds.level;
  remark = '';
  if any (jsonAt (target, {'p'}) < significance)
    remark = struct ('value', sentence ('where.off'), 'class', 'off');
  elseif isequal (jsonAt (target, {'blind'}), true)
    remark = struct ('value', sentence ('where.blind'), 'class', 'unsure');
  end
  name = fieldOf (target);
  z = struct ('value', {at(name)}, 'class', zClass (jsonNumber(target, {name})));
  value = @(field, sd) struct ('value', {at(field)}, 'sd', {at(sd)});
  cells = {targetCell(page, target), value('measured', 'sdMeasured'), ...
           value('predicted', 'sdPredicted'), differenceOf(target), z, at('p'), ...
           at('unabsorbed'), remark};
  if page.isChange
    % what both states owe to one day is in each reading, and not in their difference
    cells(2:3) = {at('measured'), at('predicted')};
  end
end

function c = differenceOf (target)
  difference = jsonNumber (target, {'measured'}) - jsonNumber (target, {'predicted'});
  c = struct ('value', difference, 'sd', ...
              difference / jsonNumber (target, {fieldOf(target)}));
end

% Before there was a field deviation, only z was kept.
function name = fieldOf (target)
  name = merge (isfield (target, 'deviation'), 'deviation', 'z');
end

function notes = notesOf (where, isChange)
  never = namesIn (where, 'neverRun');
  share = jsonNumber (where, {'surrogateShare'}, 0);
  notes = [{sentence('table.where', struct (), isChange)}, ...
           listSentences({'where.atLimit', namesIn(where, 'atLimit'); ...
                          'where.odd', namesIn(where, 'odd'); ...
                          'where.out', setdiff(namesIn (where, 'out'), never); ...
                          'where.neverRun', never; ...
                          'where.lacking', namesIn(where, 'lacking'); ...
                          'where.surrogates', ...
                          repmat({sprintf('%.0f', 100 * share)}, 1, share > 0.3)})];
end

%!test
%! T = whereTable (situationPage ('missed, named'));
%! assert (cellfun (@(c) c.value, T.cells(:, 4))', [6.2, 3.5, 0.2]);
%! assert (T.cells{2, 7}.class, 'off');
%! assert (T.cells{1, 4}.class, 'z3');
%! assert (isempty (whereTable (situationPage ('met')).cells));
%! page = situationPage ('missed, named');
%! page.isChange = true;
%! [page.sources.gap.where.targets.measured] = deal (4.1);
%! [page.sources.gap.where.targets.predicted] = deal (1);
%! T = whereTable (page);
%! assert ({T.title(1:35), T.columns{3, 1}}, {'Where the measurements have changed', ...
%!                                            'without a change'});
%! % one noise: that of the difference
%! top = T.cells(1, :);
%! assert ([top{4}.value, top{4}.sd, top{5}.value], [3.1, 0.5, 6.2], 1e-9);
%! assert (! any (isfinite ([top{2}.sd, top{3}.sd])));
%! assert (T.notes{1}, sentence ('table.where', struct (), true));

% SPDX-License-Identifier: GPL-3.0-only
