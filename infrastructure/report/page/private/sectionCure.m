% SECTIONCURE  Parts of the report: how far the effect closes the gap; what to
% measure next.
%
% CALL: LIST = sectionCure (), see writePage

function list = sectionCure ()
  list = {'sectionhowfar', 'How far the gap shrinks', @howFar, ...
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
         'xbar', 'blue', 'gap closed by the cause, 90 % interval'; ...
         'ring', 'ink', 'gap closed by another one'; ...
         'dash', 'green', 'the whole gap'};
  html = ['<p>', htmlText(page.verdict.cause.closed), '</p>', ...
          htmlFigures([deviations(far), closures(far, far, 'closure', 'fitted data'), ...
                       closures(far, jsonAt (far, {'heldOut'}), 'heldOut', ...
                                'data not fitted')], key), ...
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
% FIELD  of a placebo: of which data.
function f = closures (far, part, field, data)
  f = [];
  known = jsonNumber (part, {'closure'});
  if ~isfinite (known)
    return
  end
  placebos = jsonList (far, {'placebos'});
  names = [{far.effect}, eachOf(@(p) [p.effect, ' instead'], placebos)];
  x = 100 * cellfun (@(p) jsonNumber (p, {field}), placebos);
  n = numel (names);
  f = newFigure (['Gap closed, ', data], 'gap closed (%)', names, ...
                 sprintf ('Gap closed, %s: %s closes %.3g %%', data, far.effect, 100 * known), ...
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
%! page.verdict.cause.closed = '';
%! assert (howFar (page), '');
