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
             means, '', 'plain'; 'deviation (sd)', '', 'z'; ...
             'p', '', 'p'; 'parameters cannot hide', '', 'percent'; ...
             'remark', '', 'words'};
  columns{6, 4} = 'page';
  T = newTable (page, 'where', [titles{1 + page.isChange}, ', the largest deviation first'], ...
                columns, eachOf (@(t) rowOf (page, targets{t}, t), order), ...
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
  cells = {targetCell(page, target), ...
           struct('value', {at('measured')}, 'sd', {at('sdMeasured')}), ...
           struct('value', {at('predicted')}, 'sd', {at('sdPredicted')}), z, at('p'), ...
           at('unabsorbed'), remark};
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
%! T = whereTable (page);
%! assert ({T.title(1:35), T.columns{3, 1}}, {'Where the measurements have changed', ...
%!                                            'without a change'});
%! assert (T.notes{1}, sentence ('table.where', struct (), true));

% SPDX-License-Identifier: GPL-3.0-only
