% SECTIONCURE  Parts of the report: how far the effect closes the gap; what to
% measure next.
%
% CALL: LIST = sectionCure (), see writePage

function list = sectionCure ()
  list = {'sectionhowfar', {'How far the gap shrinks', 'How much of the change is explained'}, ...
          @howFar, ...
          {'sources', 'gap', 'howFar', 'before'}; ...
          'sectionnexttest', 'Next test', @(page) tableHtml (page.tables.next), ...
          {'sources', 'gap', 'next'}};
end

function html = howFar (page)
  html = '';
  far = page.sources.gap.howFar;
  if isempty (jsonAt (far, {'effect'})) || isempty (page.verdict.cause.closed)
    return                               % nothing was tried, or there is no gap
  end
  key = {'box', 'grey', 'without the cause'; 'box', 'blue', 'with it'; ...
         'dash', 'ink', 'noise alone'; ...
         'xbar', 'blue', 'by the cause, 90 % interval'; ...
         'ring', 'ink', 'by another one'; ...
         'dash', 'green', merge(page.isChange, 'the whole change', 'the whole gap')};
  title = merge (page.isChange, 'Change explained', 'Gap closed');
  html = ['<p>', htmlText(page.verdict.cause.closed), '</p>', ...
          htmlFigures([deviations(far), ...
                       closures(far, far, 'closure', [title, ', fitted data']), ...
                       closures(far, jsonAt (far, {'heldOut'}), 'heldOut', ...
                                [title, ', data not fitted'])], key), ...
          tableHtml(page.tables.howfar), tableHtml(page.tables.beforeafter), ...
          paramTable(page, far)];
end

function f = deviations (far)
  sets = [{far}, repmat({jsonAt(far, {'heldOut'})}, 1, isstruct (jsonAt (far, {'heldOut'})))];
  n = numel (sets);
  [factor, unit] = deal (100, '% of the range');
  if far.before >= 10
    [factor, unit] = deal (1, 'times the range');
  end
  names = {'fitted', 'not fitted'};
  x = cellfun (@(s) factor * [s.before; s.after; s.floor], sets, 'UniformOutput', false);
  f = newFigure ('Deviation of the targets', ['rms deviation (', unit, ')'], names(1:n), ...
                 sprintf ('deviation before %.3g, after %.3g, of noise alone %.3g %s', ...
                          x{1}, unit));
  f.size = [340, 80 + 46 * n];
  for k = 1:n
    y = n + 1 - k;
    f.layers = [f.layers; ...
                {'box', [0, y, 0, x{k}(1), y + 0.03, y + 0.36], 'grey'; ...
                 'box', [0, y, 0, x{k}(2), y - 0.36, y - 0.03], 'blue'; ...
                 'dash', [x{k}(3), y - 0.42; x{k}(3), y + 0.42], 'ink'}];
  end
  f.xlim = [0, 1.05 * max(vertcat (x{:}))];
end

% Share of the gap that the effect and each placebo close; PART  of gap.json,
% FIELD  of a placebo.
function f = closures (far, part, field, title)
  f = [];
  known = jsonNumber (part, {'closure'});
  if ~isfinite (known)
    return
  end
  placebos = jsonList (far, {'placebos'});
  names = plainName ([{far.effect}, eachOf(@(p) [p.effect, ' instead'], placebos)]);
  x = 100 * cellfun (@(p) jsonNumber (p, {field}), placebos);
  n = numel (names);
  f = newFigure (title, 'share (%)', names, ...
                 sprintf ('%s: %s, %.3g %%', title, names{1}, 100 * known), ...
                 {'dash', [100, 0.4; 100, n + 0.6], 'green'; ...
                  'line', [0, 0.4; 0, n + 0.6], 'grey'; ...
                  'ring', [x', (n - 1:-1:1)'], 'ink'; ...
                  'xbar', [100 * known, n, 100 * part.interval90(:)'], 'blue'});
  f.size = [340, 66 + 26 * n];
end

function html = paramTable (page, far)
  at = @(n, k) {'gap', 'howFar', 'params', n, k};
  note = {sentence('table.twoSets')};
  html = tableHtml (newTable (page, 'refitted', ...
                              'Parameters fitted without and with the cause', ...
                              {'parameter', '', ''; 'without', '', 'plain'; ...
                               'with', '', 'plain'}, ...
                              eachOf (@(n) {n, at(n, 1), at(n, 2)}, ...
                                      fieldnames (givenField (far, 'params', struct ()))), ...
                              note(~isempty (page.sources.calibration))));
end

%!test
%! % the cause beside others; without a gap nothing is said of closing it
%! page = situationPage ('missed, named');
%! page.tables = statementTables (page);
%! howFar = sectionCure (){1, 3};
%! html = howFar (page);
%! text = regexprep (html, '<[^>]*>', ' ');
%! for part = {'tilt instead', 'a +4 +4.2', 'These are not the calibrated values'}
%!   assert (! isempty (regexp (text, part{1}, 'once')), part{1});
%! end
%! assert (numel (strfind (html, '<figcaption>')), 3);
%! assert (! isempty (strfind (html, '<figcaption>Gap closed, fitted data')));
%! page.isChange = true;
%! page.sources.gap.howFar.placebos(1).effect = 'wallAdhesion';
%! html = howFar (page);
%! assert (! isempty (strfind (html, '<figcaption>Change explained, fitted data')));
%! assert (isempty (strfind (html, 'Gap closed')));
%! assert (! isempty (strfind (html, '>wall adhesion instead</text>')));
%! page.verdict.cause.closed = '';
%! assert (howFar (page), '');

% SPDX-License-Identifier: GPL-3.0-only
