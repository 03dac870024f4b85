% TARGETSTABLE  Statement: the targets, and how they are met.
%
% CALL: T = targetsTable (PAGE)
%
%   PAGE  see shownResult; of pageData also reach: what the limits reach
%   T     see newTable: largest miss over noise first; a curve is one row. Without
%         a calibration what is to be met

function T = targetsTable (page)
  if isempty (page.sources.calibration)
    T = askedFor (page);
    return
  end
  misses = page.verdict.misses;
  misses = misses(~strcmp ({misses.role}, 'unmeasured'));
  cells = arrayfun (@(m) rowOf (page, m), misses, 'UniformOutput', false);
  columns = {'result', '', 'name'; 'measured', '', 'plain'; meanHead(page), '', 'plain'; ...
             'expected mean', '', 'plain'; 'allowed +-', '', 'plain'; ...
             'miss / noise', '', 'z'; '', '', ''; 'scatter of a run', '', 'error'; ...
             'with the effect', '', 'plain'; 'your limits reach', '', 'plain'};
  columns(8:10, 4) = {'page'};
  cells = vertcat (cell (0, 10), cells{:});
  isShown = true (1, 10);
  isShown(3) = ~isequal (jsonAt (page.sources.calibration, {'runs'}), 0);
  isShown(9) = page.showsEffect && ...
               ~isempty (jsonAt (page.sources.gap, {'howFar', 'targets'}));
  T = newTable (page, 'targets', 'Measured and simulated, the largest miss over noise first', ...
                columns(isShown, :), cells(:, isShown), notesOf (page, misses, isShown(9)));
end

function cells = rowOf (page, m)
  t = targetAt (page.Case.targets, m);
  z = struct ('value', m.z, 'class', zClass (m.z));
  [class, word] = wordOf (m);
  word = struct ('value', word, 'class', class);
  if isempty (t)
    name = struct ('value', sprintf ('%s (%d points)', m.name, m.points), ...
                   'title', m.model);
    cells = {name, NaN, NaN, NaN, NaN, z, word, NaN, NaN, NaN};
    return
  end
  at = @(field) {'calibration', 'targets', t, field};
  estimate = 'estimate';
  if isempty (jsonAt (page.sources, at (estimate)))
    estimate = 'result';
  end
  own = struct ('value', {at('result')}, 'sd', {at('resultSd')});
  reach = NaN;
  if isfield (page, 'reach')
    reach = page.reach(t, :);
  end
  cure = {'howFar', 'targets'};
  k = targetAt (jsonAt (page.sources.gap, cure), m);
  cells = {targetCell(page, m), at('target'), own, at(estimate), m.allowed, z, word, ...
           at('noiseSd'), [{'gap'}, cure, {k, 'after'}], reach};
end

function [class, word] = wordOf (m)
  [class, word] = deal ('', 'not measured');
  [~, open] = missTexts (m);
  if m.isStrict && ~(abs (m.z) >= 2)
    [class, word] = deal ('unsure', 'too strict');
  elseif ~isempty (open)
    [class, word] = deal ('unsure', 'open');
  elseif m.met == 0
    [class, word] = deal ('off', 'missed');
  elseif m.met == 1 && strcmp (m.role, 'holdout')
    [class, word] = deal ('ok', 'predicted');
  elseif m.met == 1
    [class, word] = deal ('ok', 'met');
  end
end

function notes = notesOf (page, misses, hasEffect)
  notes = {sentence('table.targets')};
  for m = misses([misses.isStrict])
    notes{end + 1} = sentence ('table.strict', ...
                               struct ('name', m.name, 'scatter', m.scatter, 'allowed', ...
                                       strtrim (sprintf ('%.4g %s', m.allowed, ...
                                                         targetCell (page, m).unit))));
  end
  for m = misses(~[misses.isStrict])
    [~, open] = missTexts (m);
    if ~isempty (open)
      notes{end + 1} = [m.name, ': ', open];
    end
  end
  for m = misses(isnan ([misses.mean]) & [misses.share] > 0)
    notes{end + 1} = sprintf ('%s: %.2g times what is allowed, root mean square', ...
                              m.name, m.share);
  end
  if isequal (jsonAt (page.sources.calibration, {'runs'}), 0)
    notes{end + 1} = sentence ('table.noRun');
  end
  if hasEffect
    notes{end + 1} = ['With the effect: ', sentence('table.twoSets')];
  end
end

function text = meanHead (page)
  n = jsonAt (page.sources.calibration, {'runs'});
  text = 'DEM, one run';
  if ~isempty (n) && n > 1
    text = sprintf ('DEM, mean of %d runs', n);
  end
end

function T = askedFor (page)
  targets = page.Case.targets;
  cells = cell (numel (targets), 5);
  for t = 1:numel (targets)
    one = targets(t);
    own = struct ('model', one.modelName, 'name', one.name, 'role', one.role);
    cells(t, :) = {targetCell(page, own), one.modelName, one.value, one.sd, ...
                   halfWidth(one)};
  end
  T = newTable (page, 'targets', 'What is to be met; there is no result yet', ...
                {'result', '', 'name'; 'model', '', ''; 'measured', '', 'plain'; ...
                 'uncertainty (sd)', '', 'error'; 'allowed +-', '', 'plain'}, cells);
end

%!test
%! page = situationPage ('met, held out outside');
%! T = targetsTable (page);
%! lines = tableText (T);
%! assert (all (cellfun (@numel, lines) <= 79));
%! assert (! isempty (regexp (strjoin (lines, "\n"), 'difference \(not fitted\).* missed')));
%! assert (rows (T.cells), 3);
%! % a tolerance that no run can keep is said to be one
%! page = situationPage ('met');
%! page.verdict.misses(2).isStrict = true;
%! page.verdict.misses(2).scatter = 18;
%! T = targetsTable (page);
%! assert (T.cells{2, 7}.value, 'too strict');
%! assert (any (! cellfun (@isempty, strfind (T.notes, '18'))));
%! % nothing yet
%! page = situationPage ('nothing');
%! assert (columns (targetsTable (page).cells), 5);
