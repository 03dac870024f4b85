% TARGETSTABLE  Statement: the targets, and how they are met.
%
% CALL: T = targetsTable (PAGE)
%
%   PAGE  see shownResult; of pageData also reach: what the limits reach
%   T     see newTable: largest deviation first; a curve is one row. Without
%         a calibration what is to be met

function T = targetsTable (page)
  if isempty (page.sources.calibration)
    T = askedFor (page);
    return
  end
  misses = page.verdict.misses;
  misses = misses(~strcmp ({misses.role}, 'unmeasured'));
  runs = jsonNumber (page.sources.calibration, {'runs'}, 1);
  ofRuns = merge (runs > 1, sprintf ('DEM, mean of %d runs', runs), 'DEM, one run');
  columns = {'result', '', 'name'; 'measured', '', 'plain'; ofRuns, '', 'plain'; ...
             'expected mean', '', 'plain'; 'allowed +-', '', 'plain'; ...
             'deviation (sd)', '', 'z'; '', '', ''; 'scatter of a run', '', 'error'; ...
             'reachable', '', 'plain'};
  columns(8:9, 4) = {'page'};
  % the scatter of a run is the standard error of one
  isShown = [true(1, 2), runs > 0, true(1, 4), runs ~= 1, true];
  T = newTable (page, 'targets', 'Measured and simulated, the largest deviation first', ...
                columns(isShown, :), eachOf (@(m) rowOf (page, m, isShown), misses), ...
                notesOf (page, misses, runs == 0));
end

function cells = rowOf (page, m, isShown)
  t = targetAt (page.Case.targets, m);
  z = struct ('value', m.z, 'class', zClass (m.z));
  [class, word] = wordOf (m);
  word = struct ('value', word, 'class', class);
  if isempty (t)
    name = struct ('value', sprintf ('%s (%d points)', m.name, m.points), ...
                   'title', m.model);
    cells = {name, NaN, NaN, NaN, NaN, z, word, NaN, NaN};
    cells = cells(isShown);
    return
  end
  at = @(field) {'calibration', 'targets', t, field};
  estimate = merge (isempty (jsonAt (page.sources, at ('estimate'))), 'result', 'estimate');
  entry = struct ('value', {at('result')}, 'sd', {at('resultSd')});
  reach = givenField (page, 'reach', NaN (t, 2));
  cells = {targetCell(page, m), at('target'), entry, at(estimate), m.allowed, z, word, ...
           at('noiseSd'), reach(t, :)};
  cells = cells(isShown);
end

function [class, word] = wordOf (m)
  words = {'unsure', 'not judged', strcmp(m.state, 'unjudged'); ...
           'unsure', 'too strict', m.isStrict && ~(abs (m.z) >= 2); ...
           'unsure', 'open', isOpenMiss(m) || isLeftOpen(m); 'off', 'missed', m.met == 0; ...
           'ok', 'predicted', m.met == 1 && strcmp(m.role, 'holdout'); ...
           'ok', 'met', m.met == 1; '', 'not measured', true};
  k = find ([words{:, 3}], 1);
  [class, word] = words{k, 1:2};
end

function is = isLeftOpen (m)
  is = strcmp (m.role, 'holdout') && isnan (m.met) && isfinite (m.measured) && ...
       ~strcmp (m.state, 'unjudged');
end

function notes = notesOf (page, misses, hasNoRun)
  allowed = @(m) strtrim (sprintf ('%.4g %s', m.allowed, targetCell (page, m).unit));
  strict = eachOf (@(m) sentence ('table.strict', ...
                                  struct ('name', m.name, 'scatter', m.scatter, ...
                                          'allowed', allowed (m))), ...
                   misses([misses.isStrict]));
  plain = misses(~[misses.isStrict]);
  open = eachOf (@(m) [m.name, ': ', nthargout(2, @missTexts, m)], ...
                 plain(isOpenMiss (plain)));
  left = eachOf (@(m) [m.name, ': ', sentence('heldOut.open')], ...
                 plain(arrayfun (@isLeftOpen, plain)));
  wholes = eachOf (@(m) sprintf ('%s: %.2g times what is allowed, root mean square', ...
                                 m.name, m.share), ...
                   misses(isnan ([misses.mean]) & [misses.share] > 0));
  notes = [{sentence('table.targets')}, strict, open, left, wholes, weakOnes(page, hasNoRun), ...
           repmat({sentence('table.noRun')}, 1, hasNoRun)];
end

% What the probability rests on where a surface predicts next to nothing.
function texts = weakOnes (page, hasNoRun)
  c = page.sources.calibration;
  fits = jsonList (c, {'surrogates'});
  isWeak = cellfun (@(s) any (jsonAt (s, {'Q2'}) < 0.5), fits);
  texts = cell (1, 0);
  if any (isWeak) && isequal (c.converged, true) && ~hasNoRun
    values = struct ('names', {eachOf(@(s) s.target, fits(isWeak))}, 'runs', c.runs);
    texts = {sentence('table.weak', values)};
  end
end

function T = askedFor (page)
  row = @(one) {targetCell(page, one), one.modelName, one.value, one.sd, halfWidth(one)};
  T = newTable (page, 'targets', 'What is to be met; there is no result yet', ...
                {'result', '', 'name'; 'model', '', ''; 'measured', '', 'plain'; ...
                 'uncertainty (sd)', '', 'error'; 'allowed +-', '', 'plain'}, ...
                eachOf (row, page.Case.targets));
end

%!test
%! page = situationPage ('met, held out outside');
%! T = targetsTable (page);
%! lines = tableText (T);
%! assert (all (cellfun (@numel, lines) <= 79));
%! assert (! isempty (regexp (strjoin (lines, "\n"), 'difference \(not fitted\).* missed')));
%! assert (rows (T.cells), 3);
%! isScatter = @(T) strcmp (T.columns(:, 1), 'scatter of a run');
%! page.sources.calibration.runs = 4;
%! assert (any (isScatter (targetsTable (page))));
%! page.sources.calibration.runs = 1;
%! assert (! any (isScatter (targetsTable (page))));
%! % a tolerance that no run can keep is said to be one
%! page = situationPage ('met');
%! page.verdict.misses(2).isStrict = true;
%! page.verdict.misses(2).scatter = 18;
%! T = targetsTable (page);
%! assert (T.cells{2, 7}.value, 'too strict');
%! assert (any (! cellfun (@isempty, strfind (T.notes, '18'))));
%! % all of them
%! [page.verdict.misses.isStrict] = deal (true);
%! [page.verdict.misses.scatter] = deal (18);
%! assert (any (! cellfun (@isempty, strfind (targetsTable (page).notes, '18'))));
%! % what a probability rests on where the surface predicts nothing
%! page = situationPage ('met');
%! page.sources.calibration.surrogates(2).Q2 = 0.3;
%! assert (any (! cellfun (@isempty, strfind (targetsTable (page).notes, ...
%!                                            'product: the fitted surfaces do not'))));
%! % nothing yet
%! page = situationPage ('nothing');
%! assert (columns (targetsTable (page).cells), 5);

% SPDX-License-Identifier: GPL-3.0-only
