% SECTIONWHERE  Part of the report: where the measurements are missed.
%
% CALL: [TITLE, HTML] = sectionWhere (PAGE), see writePage and pageData

function [title, html] = sectionWhere (page)
  title = 'Where the model misses';
  html = '';
  where = jsonAt (page.sources.gap, {'where'});
  if isempty (where) || isempty (jsonAt (where, {'targets'}))
    return
  end
  html = [leadIn(page, where), mapTable(page, where), curves(page, where), ...
          targetTable(page, where), hidden(page, where)];
end

function html = leadIn (page, where)
  models = {'the calibrated model', 'what the reference foretells'};
  model = models{1 + ~isempty(jsonAt (page.sources.gap, {'reference'}))};
  html = ['<p>Noise alone would make ', model, ' miss these ', ...
          'measurements by as much with p&nbsp;=&nbsp;', ...
          pageNumber(page, 'plain', 'gap', 'where', 'p'), '.'];
  limits = jsonAt (where, {'atLimit'});
  if ~isempty (limits)
    html = [html, ' To come this close the parameters go to their limit: ', ...
            htmlText(strjoin (cellstr (limits)(:)', ', ')), '.'];
  end
  never = namesIn (where, 'neverRun');
  html = [html, outOf('None of its runs gave a result', ...
                      setdiff (namesIn (where, 'out'), never)), ...
          outOf('It was never run to its end', never)];
  if isfield (where, 'surrogateShare')
    html = [html, ' Of the noise, ', ...
            pageNumber(page, 'percent', 'gap', 'where', 'surrogateShare'), ...
            ' is the uncertainty of the surrogates.'];
  end
  html = [html, '</p>'];
end

function html = outOf (reason, benches)
  html = '';
  if ~isempty (benches)
    html = [' ', reason, ', so it takes no part: ', ...
            htmlText(strjoin (benches(:)', ', ')), '.'];
  end
end

% One row a bench, one cell a target: deviation in units of its noise.
function html = mapTable (page, where)
  n = numel (where.targets);
  models = cell (1, n);
  for t = 1:n
    models{t} = jsonAt (where.targets, {t, 'model'});
  end
  benches = unique (models, 'stable');
  width = max (cellfun (@(b) sum (strcmp (b, models)), benches));
  lines = '';
  for b = 1:numel (benches)
    mine = find (strcmp (benches{b}, models));
    cells = '';
    for t = mine
      cells = [cells, mapCell(page, where, t)];
    end
    cells = [cells, repmat('<td></td>', 1, width - numel (mine))];
    lines = [lines, '<tr><th scope="row">', htmlText(benches{b}), '</th>', ...
             cells, "</tr>\n"];
  end
  html = ['<h3>Map of benches and targets</h3><div class="scroll" ', ...
          'role="region" tabindex="0" aria-label="Map of benches and ', ...
          'targets"><table class="map"><caption><span>Measured less ', ...
          'simulated, in units of the noise; beyond 2 coloured, beyond 3 ', ...
          'strongly.</span></caption><thead><tr><th scope="col">bench</th>', ...
          sprintf(['<th scope="col" class="text" colspan="%d">', ...
                   'targets</th>'], width), ...
          '</tr></thead><tbody>', lines, "</tbody></table></div>\n"];
end

function html = mapCell (page, where, t)
  z = abs (jsonAt (where.targets, {t, 'z'}));
  level = sum ([z, NaN](1) >= 1:3);
  class = '';
  if level > 0
    class = sprintf (' class="z%d"', level);
  end
  held = '';
  if strcmp (jsonAt (where.targets, {t, 'role'}), 'holdout')
    held = ', held out';
  end
  html = ['<td', class, '>', htmlText(jsonAt (where.targets, {t, 'name'})), ...
          held, '<br>', pageNumber(page, 'z', 'gap', 'where', 'targets', ...
                                   t, 'z'), '</td>'];
end

function html = curves (page, where)
  html = '';
  figures = curveFigures (page, where);
  if ~isempty (figures)
    key = htmlKey ({'ybar', 'ink', 'measured &plusmn; 1 sd'; ...
                    'line', 'blue', 'simulated with the fitted parameters'; ...
                    'area', 'paleblue', ...
                    'its noise (90 %: packing and surrogate)'});
    html = ['<h3>Measured against simulated</h3>', ...
            htmlFigures(figures, key)];
  end
end

function html = targetTable (page, where)
  table = page.sources.gapTargets;
  n = numel (where.targets);
  cells = cell (n, 9);
  for t = 1:n
    target = jsonAt (where.targets, {t});
    at = @(kind, field) pageNumber (page, kind, 'gap', 'where', 'targets', ...
                                    t, field);
    row = 0;
    if isfield (table, 'target')
      row = find (strcmp ({table.target}, target.name) & ...
                  strcmp ({table.model}, target.model), 1);
    end
    numbers = repmat ({'&ndash;'}, 1, 3);
    if ~isempty (row) && row > 0
      numbers = {pageNumber(page, 'plain', 'gapTargets', row, 'measured'), ...
                 pageNumber(page, 'plain', 'gapTargets', row, ...
                            'sd_measured'), ...
                 pageNumber(page, 'plain', 'gapTargets', row, 'predicted')};
    end
    cells(t, :) = {[htmlText(target.model), ': ', htmlText(target.name)], ...
                   htmlText(target.role), numbers{:}, at('z', 'z'), ...
                   at('plain', 'p'), at('percent', 'unabsorbed'), ...
                   remark(target)};
  end
  html = htmlTable (['All targets of the diagnosis; p: how often noise ', ...
                     'alone makes one of the fitted (or held-out) ones as ', ...
                     'odd'], ...
                    {'target', 'role', 'measured', '&plusmn; (sd)', ...
                     'simulated', 'miss / noise', 'p', ...
                     'parameters cannot hide', 'remark'}, cells);
end

function text = remark (target)
  text = '';
  if isfield (target, 'p') && ~isempty (target.p) && target.p < 0.05
    text = '<span class="off">off</span>';
  elseif isfield (target, 'blind') && isequal (target.blind, true)
    text = '<span class="unsure">blind: parameters can hide an error</span>';
  end
end

function html = hidden (page, where)
  html = '';
  params = jsonAt (where, {'params'});
  if ~isstruct (params)
    return
  end
  names = fieldnames (params);
  limits = page.Case.limits;
  cells = cell (numel (names), 4);
  for j = 1:numel (names)
    known = find (strcmp (names{j}, page.Case.names), 1);
    box = {'', ''};
    if ~isempty (known)
      box = {numberText(limits(1, known)), numberText(limits(2, known))};
    end
    cells(j, :) = {htmlText(names{j}), ...
                   pageNumber(page, 'plain', 'gap', 'where', 'params', ...
                              names{j}), box{:}};
  end
  html = htmlTable ('Parameters of the best fit without any effect', ...
                    {'parameter', 'value', 'lower limit', 'upper limit'}, ...
                    cells);
  if ~isempty (page.sources.calibration)
    html = [html, '<p>', whyTwoSets(), '</p>'];
  end
end

% Results of one series (results.csv of the model) as a curve over where they
% were measured.
function figures = curveFigures (page, where)
  figures = [];
  table = page.sources.gapTargets;
  if ~isfield (table, {'model', 'target', 'measured', 'predicted'})
    return
  end
  benches = unique ({table.model}, 'stable');
  for b = 1:numel (benches)
    mine = table(strcmp ({table.model}, benches{b}));
    [series, at, unit] = seriesOf (page.Case, benches{b}, mine);
    for name = unique (series(~cellfun (@isempty, series)))
      points = find (strcmp (series, name{1}) & isfinite (at));
      if numel (points) > 2
        figures = [figures, curve(mine(points), at(points), ...
                                  sprintf ('%s: %s', benches{b}, name{1}), ...
                                  unit{points(1)})];
      end
    end
  end
end

function [series, at, unit] = seriesOf (Case, bench, mine)
  series = repmat ({''}, 1, numel (mine));
  at = NaN (1, numel (mine));
  unit = series;
  k = find (strcmp (bench, {Case.models.name}), 1);
  if isempty (k)
    return
  end
  isOwn = [Case.targets.model] == k;
  info = targetInfo (Case)(isOwn);
  own = Case.targets(isOwn);
  for i = 1:numel (mine)
    t = find (strcmp (mine(i).target, {own.name}), 1);
    if ~isempty (t)
      r = info(t);
      series{i} = r.series;
      at(i) = r.at;
      unit{i} = strrep (r.unit, '-', '');
    end
  end
end

function f = curve (points, at, title, unit)
  [at, order] = sort (at);
  points = points(order);
  measured = [points.measured]';
  simulated = [points.predicted]';
  sd = [points.sd_measured]';
  noise = 1.64 * hypot ([points.sd_trial]', [points.sd_surrogate]');
  alt = sprintf ('%s: measured and simulated at %d points', title, ...
                 numel (at));
  f = newFigure (title, 'where it was measured', unit, alt);
  at = at(:);
  f = addLayer (f, 'area', [at, simulated - noise, simulated + noise], ...
                'paleblue');
  f = addLayer (f, 'line', [at, simulated], 'blue');
  f = addLayer (f, 'ybar', [at, measured, measured - sd, measured + sd], ...
                'ink');
end

%!test
%! page = situationPage ('missed, named');
%! [~, html] = sectionWhere (page);
%! text = regexprep (html, '(<[^>]*>|\s)+', ' ');
%! assert (! isempty (strfind (text, 'p&nbsp;=&nbsp; 0.001')));
%! assert (! isempty (strfind (text, 'First: sum calibrate')));
%! assert (numel (strfind (html, 'class="z3"')), 2);
