% MATERIALCARD  All that is known of a material, with the evidence for each value.
%
% CALL: CARD = materialCard (LIST, RESULTS)
%
%   LIST     1 x n struct, see materialValues: of the case that is asked
%   RESULTS  1 x r struct: name (of a case), remarks (cell of texts, of its
%            measured.csv), calibration (decoded results/calibration.json); the first
%            is that of the case itself
%   CARD     scalar struct, ready for JSON:
%     material  cell of texts, remarks of the first case
%     values    cell of structs name, label, unit, value, interval (90 %; NaN: none),
%               from ('calibrated', 'given', 'model'), case, models, by (targets that
%               drive it), determined (the tests of that case determine it), confirmed
%               (they do, and all its targets are met), agrees (true, false; []: one
%               case alone has an interval), others (cell of structs
%               case, value, interval, confirmed)
%     cases     cell of structs name, models, converged, reason, date, version
%     tests     cell of structs case, model, name, unit, target, sd, result, resultSd,
%               role, state
%
% Where several cases have calibrated a value, that of a confirmed one with the
% narrowest interval stands, the others beside it. They agree where all intervals
% overlap.
%
% See also: sayExport, cardPage

function card = materialCard (list, results)
  card = struct ('material', {results(1).remarks}, 'values', {{}}, 'cases', {{}}, ...
                 'tests', {{}});
  for r = results
    c = r.calibration;
    entry = mergeFields (struct ('name', r.name, 'models', {modelsOf(c)}), c, ...
                         {'converged', 'reason', 'date', 'version'});
    card.cases{end + 1} = entry;
    fields = {'model', 'name', 'unit', 'target', 'sd', 'result', 'resultSd', 'role', ...
              'state'};
    for k = 1:numel (givenField (c, 'targets', []))
      card.tests{end + 1} = mergeFields (struct ('case', r.name), ...
                                         jsonAt (c, {'targets', k}), fields);
    end
    missing = setdiff (fieldnames (c.params)', {list.name});
    for name = missing
      list(end + 1) = struct ('name', name{1}, 'value', NaN, 'interval', [NaN, NaN], ...
                              'from', 'calibrated', 'label', '', 'unit', '');
    end
  end
  card.values = eachOf (@(one) valueOf (one, results), list);
end

function names = modelsOf (c)
  names = eachOf (@(m) m.name, jsonList (c, {'input', 'models'}));
end

function v = valueOf (one, results)
  known = struct ('case', {}, 'value', {}, 'interval', {}, 'determined', {}, ...
                  'confirmed', {}, ...
                  'models', {}, 'by', {});
  for r = results
    c = r.calibration;
    if isfield (c.params, one.name)
      range = jsonAt (c, {'interval90', one.name});
      if ~(isnumeric (range) && numel (range) == 2)
        range = [NaN, NaN];
      end
      isDetermined = ~any (strcmp (one.name, [namesIn(c, 'notIdentified'), ...
                                              namesIn(c, 'atLimit')]));
      isMet = isequal (givenField (c, 'converged', 0), true);
      known(end + 1) = struct ('case', r.name, 'value', c.params.(one.name), ...
                               'interval', range(:)', 'determined', isDetermined, ...
                               'confirmed', isMet && isDetermined, ...
                               'models', {modelsOf(c)}, 'by', {drivenBy(c, one.name)});
    end
  end
  v = struct ('name', one.name, 'label', one.label, 'unit', one.unit, ...
              'value', one.value, 'interval', one.interval, 'from', one.from, ...
              'case', results(1).name, 'models', {{}}, 'by', {{}}, ...
              'determined', false, 'confirmed', false, 'agrees', [], 'others', {{}});
  if isempty (known)
    return
  end
  ranges = vertcat (known.interval);
  width = diff (ranges, 1, 2)';
  width(isnan (width)) = Inf;
  [~, order] = sortrows ([~[known.confirmed]', width']);
  v = mergeFields (v, known(order(1)));
  v.from = 'calibrated';
  hasRange = all (isfinite (ranges), 2);
  if sum (hasRange) > 1
    v.agrees = max (ranges(hasRange, 1)) <= min (ranges(hasRange, 2));
  end
  v.others = num2cell (rmfield (known(order(2:end)), {'models', 'by'}));
end

% Results of which the parameter drives a tenth of the variance or more.
function names = drivenBy (c, name)
  share = jsonAt (c, {'sensitivity', name})(:)';
  names = {};
  for t = find (share >= 0.1)
    if strcmp (jsonAt (c, {'targets', t, 'role'}), 'calibrate')
      names{end + 1} = jsonAt (c, {'targets', t, 'name'});
    end
  end
end

%!function r = result (name, value, range, converged)
%!  r = struct ('name', name, 'remarks', {{['sand of ', name]}});
%!  r.calibration = struct ('params', struct ('mu', value), ...
%!    'interval90', struct ('mu', range), 'converged', converged, 'reason', 'x', ...
%!    'date', '2026-01-01', 'version', '1', 'sensitivity', ...
%!    struct ('mu', [0.8; 0.05]), 'targets', struct ('model', 'Heap', ...
%!    'name', {'slope', 'mass'}, 'unit', 'deg', 'target', 3, 'sd', 1, 'result', 3, ...
%!    'resultSd', 1, 'role', 'calibrate', 'state', 'met'));
%!  r.calibration.input.models = struct ('name', 'Heap');
%!endfunction
%!test
%! list = struct ('name', {'mu', 'rho'}, 'value', {0.4, 1200}, 'interval', ...
%!                [NaN, NaN], 'from', {'calibrated', 'given'}, 'label', '', 'unit', '');
%! results = [result('a', 0.4, [0.2, 0.6], true), result('b', 0.5, [0.4, 0.55], true), ...
%!            result('c', 0.52, [0.51, 0.53], false)];
%! card = materialCard (list, results);
%! assert (card.material, {'sand of a'});
%! v = card.values{1};
%! assert ({v.case, v.value, v.by, v.agrees}, {'b', 0.5, {'slope'}, true});
%! assert (cellfun (@(o) o.case, v.others), 'ac');
%! assert ([numel(card.cases), numel(card.tests)], [3, 6]);
%! % what the tests do not determine is not confirmed
%! open = results(1);
%! open.calibration.notIdentified = {'mu'};
%! v = materialCard (list, open).values{1};
%! assert ([v.determined, v.confirmed], [false, false]);
%! assert ({card.values{2}.from, card.values{2}.value}, {'given', 1200});
%! results(2).calibration.interval90.mu = [0.7; 0.8];
%! assert (materialCard (list, results).values{1}.agrees, false);

% SPDX-License-Identifier: GPL-3.0-only
