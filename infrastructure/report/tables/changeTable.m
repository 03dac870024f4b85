% CHANGETABLE  Statement: what was measured before and after a change.
%
% CALL: [T, CONDITIONS] = changeTable (PAGE)
%
%   PAGE        see shownResult
%   T           see newTable; [] for a case without conditions
%   CONDITIONS  see newTable: one line each, with what has changed and its file

function [T, conditions] = changeTable (page)
  [T, conditions] = deal ([]);
  reference = jsonAt (page.sources.gap, {'reference'});
  if isempty (reference)
    return
  end
  n = numel (reference.targets);
  cells = cell (n, 6);
  for t = 1:n
    own = jsonAt (reference.targets, {t});
    at = @(field) {'gap', 'reference', 'targets', t, field};
    z = jsonNumber (own, {'z'});
    modelled = jsonNumber (own, {'modelled'});
    cells(t, :) = {targetCell(page, own), at('reference'), at('measured'), ...
                   struct('value', own.measured - own.reference, ...
                          'sd', jsonNumber(own, {'sd'})), ...
                   modelled - own.reference, struct('value', z, 'class', zClass (z))};
  end
  T = newTable (page, 'change', ['Before and after: reference and ', reference.condition], ...
                {'result', '', 'name'; 'reference', '', 'plain'; ...
                 reference.condition, '', 'plain'; 'change +- noise', '', 'change'; ...
                 'modelled change', '', 'change'; 'change / noise', '', 'z'}, cells, ...
                {sentence('table.change')});
  conditions = conditionNames (page, reference);
end

function T = conditionNames (page, reference)
  list = conditionTexts (page.sources.gap);
  notes = {};
  for k = 1:numel (jsonAt (reference, {'order'}))
    one = jsonAt (reference, {'order', k});
    one.probability = plainNumber (one.probability, 'probability');
    notes{end + 1} = sentence ('change.order', one);
  end
  T = newTable (page, 'conditions', 'What has changed, the surest first', ...
                {'condition', '', ''; 'what has changed (90 % interval)', '', 'words'; ...
                 'probability', '', 'probability'; 'values', '', ''}, ...
                [{list.name}', {list.text}', {list.probability}', {list.file}'], notes);
end

%!test
%! page = situationPage ('missed, named');
%! assert (isempty (changeTable (page)));
%! target = struct ('model', 'First', 'name', 'sum', 'reference', 7, 'measured', 6, ...
%!                  'foretold', 7, 'modelled', 6.5, 'sd', 0.25, 'z', -4);
%! one = struct ('name', {'moist', 'wet'}, 'verdict', 'named', 'effects', 'cohesion', ...
%!               'probability', {0.8, 0.99}, 'text', {'cohesion 14 kJ/m3', 'cohesion 47 kJ/m3'});
%! page.sources.gap.reference = struct ('condition', 'moist', 'targets', target, ...
%!   'conditions', one, 'order', struct ('effect', 'cohesion', 'more', 'wet', ...
%!                                       'less', 'moist', 'probability', 0.97));
%! [T, all_] = changeTable (page);
%! assert ({T.cells{1, 4}.value, T.cells{1, 4}.sd, T.cells{1, 5}.value}, {-1, 0.25, -0.5});
%! assert (cellfun (@(c) c.value, all_.cells(:, 4)', 'UniformOutput', false), ...
%!         {'gap/wet/calibrated.head', 'gap/calibrated.head'});
%! assert (all_.notes, {'More cohesion in wet than in moist: probability 0.97.'});
