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
  cure = page.sources.gap.howFar;
  effect = jsonAt (cure, {'effect'});
  if isempty (effect) || isempty (page.verdict.cause.closed)
    return                               % nothing was tried, or there is no gap
  end
  key = {'box', 'grey', 'without the cause'; 'box', 'blue', 'with it'; ...
         'dash', 'ink', 'noise alone'; ...
         'xbar', 'blue', 'gap closed by the cause, 90 % interval'; ...
         'ring', 'ink', 'gap closed by another one'; ...
         'dash', 'green', 'the whole gap'};
  html = ['<p>', htmlText(page.verdict.cause.closed), '</p>', ...
          htmlFigures([deviations(cure), ...
                       closures(cure, effect, cure, 'closure'), ...
                       closures(cure, effect, jsonAt (cure, {'heldOut'}), ...
                                'heldOut')], key), ...
          tableHtml(page.tables.howfar), tableHtml(page.tables.beforeafter), ...
          paramTable(page, cure)];
end

function f = deviations (cure)
  sets = {cure};
  held = jsonAt (cure, {'heldOut'});
  if isstruct (held)
    sets{2} = held;
  end
  n = numel (sets);
  names = {'fitted', 'not fitted'};
  [factor, unit] = deal (100, '% of the range');
  if cure.before >= 10
    [factor, unit] = deal (1, 'times the range');
  end
  alt = sprintf ('deviation before %.3g, after %.3g, of noise alone %.3g %s', ...
                 factor * [cure.before, cure.after, cure.floor], unit);
  f = newFigure ('Deviation of the targets', ['rms deviation (', unit, ')'], names(1:n), ...
                 alt);
  f.size = [340, 80 + 46 * n];
  most = 0;
  for k = 1:n
    y = n + 1 - k;
    x = factor * [sets{k}.before, sets{k}.after, sets{k}.floor];
    f.layers = [f.layers; ...
                {'box', [0, y, 0, x(1), y + 0.03, y + 0.36], 'grey'; ...
                 'box', [0, y, 0, x(2), y - 0.36, y - 0.03], 'blue'; ...
                 'dash', [x(3), y - 0.42; x(3), y + 0.42], 'ink'}];
    most = max ([most, x]);
  end
  f.xlim = [0, 1.05 * most];
end

% Share of the gap that the effect and each placebo close; PART  of gap.json,
% FIELD  of a placebo: on the calibrated targets, or the held-out ones.
function f = closures (cure, effect, part, field)
  f = [];
  titles = struct ('closure', 'Gap closed, fitted data', ...
                   'heldOut', 'Gap closed, data not fitted');
  title = titles.(field);
  known = jsonAt (part, {'closure'});
  if isempty (known) || ~isfinite (known)
    return
  end
  names = {effect};
  x = 100 * known;
  placebos = jsonAt (cure, {'placebos'});
  for k = 1:numel (placebos)
    names{end + 1} = [jsonAt(placebos, {k, 'effect'}), ' instead'];
    share = [jsonAt(placebos, {k, field}), NaN];
    x(end + 1) = 100 * share(1);
  end
  n = numel (names);
  f = newFigure (title, 'gap closed (%)', names, ...
                 sprintf ('%s: %s closes %.3g %%', title, effect, x(1)), ...
                 {'dash', [100, 0.4; 100, n + 0.6], 'green'; ...
                  'line', [0, 0.4; 0, n + 0.6], 'grey'; ...
                  'ring', [x(2:end)', (n - 1:-1:1)'], 'ink'; ...
                  'xbar', [x(1), n, 100 * part.interval90(:)'], 'blue'});
  f.size = [340, 66 + 26 * n];
end

function html = paramTable (page, cure)
  html = '';
  if ~isstruct (jsonAt (cure, {'params'}))
    return
  end
  names = fieldnames (cure.params)';
  at = @(n, k) {'gap', 'howFar', 'params', n, k};
  cells = cellfun (@(n) {n, at(n, 1), at(n, 2)}, names, 'UniformOutput', false);
  note = {sentence('table.twoSets')};
  html = tableHtml (newTable (page, 'refitted', ...
                              'Parameters fitted without and with the cause', ...
                              {'parameter', '', ''; 'without', '', 'plain'; ...
                               'with', '', 'plain'}, vertcat (cells{:}), ...
                              note(~isempty (page.sources.calibration))));
end

%!test
%! % the cause beside others; without a gap nothing is said of closing it
%! page = situationPage ('missed, named');
%! page.tables = statementTables (page);
%! howFar = sectionCure (){1, 3};
%! html = howFar (page);
%! text = regexprep (html, '<[^>]*>', ' ');
%! for part = {'tilt instead', 'a +4 +4.2', 'This is another set'}
%!   assert (! isempty (regexp (text, part{1}, 'once')), part{1});
%! end
%! assert (numel (strfind (html, '<figcaption>')), 3);
%! page.verdict.cause.closed = '';
%! assert (howFar (page), '');
