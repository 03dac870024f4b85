% CHANGETABLE  Statement: what was measured before and after a change.
%
% CALL: [T, CONDITIONS] = changeTable (PAGE)
%
%   PAGE        see shownResult
%   T           see newTable; [] for a case without conditions
%   CONDITIONS  see newTable: one line each, with what has changed and its file; []
%               where nothing is named in any: the verdict says that
%
% What the model makes of the change is shown with the cause that the verdict tried,
% and where it tried one.

function [T, conditions] = changeTable (page)
  [T, conditions] = deal ([]);
  reference = jsonAt (page.sources.gap, {'reference'});
  if isempty (reference)
    return
  end
  rows_ = eachOf (@(t) rowOf (page, t, jsonAt (reference.targets, {t})), ...
                  1:numel (reference.targets));
  effect = plainName (char (jsonAt (page.sources.gap, {'howFar', 'effect'})));
  isTried = ~isempty (effect) && ~isempty (jsonAt (page, {'verdict', 'cause', 'closed'}));
  isShown = [true(1, 5), isTried];
  rows_ = eachOf (@(cells) cells(isShown), rows_);
  heads = {'result', '', 'name'; 'reference', '', 'plain'; ...
           reference.condition, '', 'plain'; 'change +- noise', '', 'change'; ...
           'times the noise', '', 'z'; ['with ', effect], '', 'change'};
  T = newTable (page, 'change', ['Before and after: reference and ', reference.condition], ...
                heads(isShown, :), rows_, ...
                [{sentence('table.change')}, ...
                 listSentences({'table.changeWith', repmat({effect}, 1, isTried)}), ...
                 followsText(reference), jsonAt(page, {'verdict', 'cause', 'notFollowed'})]);
  list = conditionTexts (page.sources.gap);
  if all (strcmp ({list.code}, 'open'))
    return
  end
  order = eachOf (@(one) setfield (one, 'probability', ...
                                   plainNumber (one.probability, 'probability')), ...
                  jsonList (reference, {'order'}));
  conditions = newTable (page, 'conditions', 'What has changed, the most probable first', ...
                         {'condition', '', ''; 'what has changed (90 % interval)', '', 'words'; ...
                          'probability', '', 'probability'; 'values', '', ''}, ...
                         eachOf (@(c) {c.name, c.text, c.probability, c.file}, list), ...
                         eachOf (@(one) sentence ('change.order', one), order));
end

% How well the bench gives the reference; of one reading alone nothing is said, as the
% last one is not set aside.
function text = followsText (reference)
  isFollowed = cellfun (@(T) givenField (T, 'followed', true), ...
                        jsonList (reference, {'targets'}));
  values = struct ('n', sum (isFollowed), 'of', numel (isFollowed));
  text = {};
  if values.of > 1
    text = {sentence('change.follows', values)};
  end
end

function cells = rowOf (page, t, own)
  at = @(field) {'gap', 'reference', 'targets', t, field};
  z = (own.measured - own.reference) / jsonNumber (own, {'sd'});
  cells = {targetCell(page, own), at('reference'), at('measured'), ...
           struct('value', own.measured - own.reference, 'sd', jsonNumber(own, {'sd'})), ...
           struct('value', z, 'class', zClass (z)), ...
           jsonNumber(own, {'modelled'}) - own.reference};
end

%!test
%! page = situationPage ('missed, named');
%! assert (isempty (changeTable (page)));
%! target = struct ('model', 'First', 'name', 'sum', 'reference', 7, 'measured', 6, ...
%!                  'foretold', 7, 'modelled', 6.5, 'sd', 0.25, 'z', -4);
%! one = struct ('name', {'moist', 'wet'}, 'verdict', 'named', 'code', 'named', ...
%!               'kind', 'found', 'effects', 'cohesion', 'probability', {0.8, 0.99}, ...
%!               'text', {'cohesion 14 kJ/m3', 'cohesion 47 kJ/m3'});
%! page.sources.gap.reference = struct ('condition', 'moist', 'targets', target, ...
%!   'conditions', one, 'order', struct ('effect', 'cohesion', 'more', 'wet', ...
%!                                       'less', 'moist', 'probability', 0.97));
%! page.sources.gap.howFar.effect = 'wallAdhesion';
%! page.verdict.cause.closed = 'half of it';
%! [T, whole] = changeTable (page);
%! assert ({T.cells{1, 4}.value, T.cells{1, 4}.sd, T.cells{1, 6}.value}, {-1, 0.25, -0.5});
%! assert (T.columns(5:6, 1)', {'times the noise', 'with wall adhesion'});
%! assert (numel (strfind ([T.notes{:}], 'With wall adhesion: ')), 1);
%! assert (cellfun (@(c) c.value, whole.cells(:, 4)', 'UniformOutput', false), ...
%!         {'gap/wet/calibrated.head', 'gap/calibrated.head'});
%! assert (whole.notes, {'More cohesion in wet than in moist: probability 0.97.'});
%! % without a cause no column of one, and no table of one condition
%! page.verdict.cause.closed = '';
%! [one(1).effects, one(1).code, one(1).kind] = deal ({}, 'none', 'none');
%! page.sources.gap.reference.conditions = one(1);
%! [T, whole] = changeTable (page);
%! assert (columns (T.cells), 5);
%! assert (isempty (whole));
%! page.sources.gap.reference.conditions = [one(1), setfield(one(1), 'name', 'dry')];
%! assert (isempty (nthargout (2, @changeTable, page)));

% SPDX-License-Identifier: GPL-3.0-only
