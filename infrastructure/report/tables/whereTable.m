% WHERETABLE  Statement: where the measurements are missed.
%
% CALL: T = whereTable (PAGE)
%
%   PAGE  see shownResult
%   T     see newTable, the largest miss over noise first; [] without a diagnosis

function T = whereTable (page)
  T = [];
  targets = jsonAt (page.sources.gap, {'where', 'targets'});
  n = numel (targets);
  if n == 0
    return
  end
  z = arrayfun (@(t) jsonNumber (targets, {t, 'z'}), 1:n);
  [~, order] = sort (-abs (z));
  cells = arrayfun (@(t) rowOf (page, jsonAt (targets, {t}), t), order, ...
                    'UniformOutput', false);
  words = {'simulated', 'foretold'};
  columns = {'result', '', 'name'; 'measured', '', 'plain'; ...
             words{1 + page.isChange}, '', 'plain'; 'miss / noise', '', 'z'; ...
             'p', '', 'p'; 'parameters cannot hide', '', 'percent'; ...
             'remark', '', 'words'};
  columns{6, 4} = 'page';
  T = newTable (page, 'where', 'Where the measurements are missed, the largest miss first', ...
                columns, vertcat (cells{:}), notesOf (page.sources.gap.where));
end

function cells = rowOf (page, target, t)
  at = @(field) {'gap', 'where', 'targets', t, field};
  remark = struct ('value', '', 'class', '');
  if isequal (jsonAt (target, {'p'}) < thresholdOf (page.sources.gap, 'level', 0.05), ...
              true)
    remark = struct ('value', sentence ('where.off'), 'class', 'off');
  elseif isequal (jsonAt (target, {'blind'}), true)
    remark = struct ('value', sentence ('where.blind'), 'class', 'unsure');
  end
  z = struct ('value', {at('z')}, 'class', zClass (jsonNumber(target, {'z'})));
  measured = struct ('value', {at('measured')}, 'sd', {at('sdMeasured')});
  predicted = struct ('value', {at('predicted')}, 'sd', {at('sdPredicted')});
  cells = {targetCell(page, target), measured, predicted, z, at('p'), ...
           at('unabsorbed'), remark};
end

function notes = notesOf (where)
  notes = {sentence('table.where')};
  never = namesIn (where, 'neverRun');
  lists = {'where.atLimit', namesIn(where, 'atLimit'); ...
           'where.odd', namesIn(where, 'odd'); ...
           'where.out', setdiff(namesIn (where, 'out'), never); ...
           'where.neverRun', never};
  for one = lists(~cellfun (@isempty, lists(:, 2)), :)'
    notes{end + 1} = sentence (one{1}, struct ('names', {one{2}}));
  end
  if isfield (where, 'surrogateShare') && where.surrogateShare > 0.3
    notes{end + 1} = sentence ('where.surrogates', ...
                               struct ('share', round (100 * where.surrogateShare)));
  end
end

%!test
%! T = whereTable (situationPage ('missed, named'));
%! assert (cellfun (@(c) c.value, T.cells(:, 4))', [6.2, 3.5, 0.2]);
%! assert (T.cells{2, 7}.class, 'off');
%! assert (T.cells{1, 4}.class, 'z3');
%! assert (isempty (whereTable (situationPage ('met'))));
