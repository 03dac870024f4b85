% SECTIONWHERE  Part of the report: where the measurements are missed.
%
% CALL: LIST = sectionWhere (), see writePage

function list = sectionWhere ()
  list = {'sectionwhere', 'Where the model misses', @where, ...
          {'sources', 'gap', 'where', 'targets'}};
end

function html = where (page)
  found = page.sources.gap.where;
  html = ['<p>', htmlText(sentence ('where.chance', struct (), page.isChange)), ' ', ...
          pageNumber(page, 'p', 'gap', 'where', 'p'), '.</p>', ...
          curves(page), tableHtml(page.tables.where), hidden(page, found)];
end

function html = hidden (page, where)
  html = '';
  if ~isstruct (jsonAt (where, {'params'}))
    return
  end
  names = page.Case.names(isfield (where.params, page.Case.names));
  cells = cellfun (@(n) {n, {'gap', 'where', 'params', n}, ...
                         page.Case.limits(1:2, strcmp (n, page.Case.names))}, names, ...
                   'UniformOutput', false);
  note = {sentence('table.twoSets')};
  html = tableHtml (newTable (page, 'fitted', ...
                              'Parameters of the best fit without any cause', ...
                              {'parameter', '', ''; 'value', '', 'plain'; ...
                               'limits', '', 'plain'}, vertcat (cell (0, 3), cells{:}), ...
                              note(~isempty (page.sources.calibration))));
end

% Results of one series (results.csv of the model) as a curve over where they
% were measured.
function html = curves (page)
  html = '';
  figures = [];
  table = onSeries (page);
  if isempty (table)
    return
  end
  for bench = unique ({table.model}, 'stable')
    mine = table(strcmp ({table.model}, bench{1}));
    for name = unique ({mine.series})
      points = mine(strcmp ({mine.series}, name{1}));
      if numel (points) > 2
        figures = [figures, curve(points, [bench{1}, ': ', name{1}])];
      end
    end
  end
  if ~isempty (figures)
    key = {'ybar', 'ink', 'measured &plusmn; 1 sd'; ...
           'line', 'blue', 'simulated with the fitted parameters'; ...
           'area', 'paleblue', 'its noise (90 %: packing and surrogate)'};
    html = ['<h3>Measured against simulated</h3>', htmlFigures(figures, key)];
  end
end

% The targets that belong to a series, with series, at and unit.
function table = onSeries (page)
  table = [];
  info = targetInfo (page.Case);
  rows_ = page.sources.gap.where.targets;
  for k = 1:numel (rows_)
    row = jsonAt (rows_, {k});
    t = targetAt (page.Case.targets, row);
    if ~isempty (t) && ~isempty (info(t).series) && isfinite (info(t).at) && ...
       ~isempty (jsonAt (row, {'predicted'}))
      row = mergeFields (struct (), row, {'model', 'measured', 'predicted', ...
                                          'sdMeasured', 'sdPredicted'});
      [row.series, row.at] = deal (info(t).series, info(t).at);
      row.unit = page.targets(t).unit;
      table = [table, row];
    end
  end
end

function f = curve (points, title)
  unit = points(1).unit;
  [at, order] = sort ([points.at]');
  points = points(order);
  measured = [points.measured]';
  simulated = [points.predicted]';
  sd = [points.sdMeasured]';
  noise = 1.64 * [points.sdPredicted]';
  f = newFigure (title, 'where it was measured', unit, ...
                 sprintf ('%s: measured and simulated at %d points', title, ...
                          numel (at)), ...
                 {'area', [at, simulated - noise, simulated + noise], ...
                  'paleblue'; 'line', [at, simulated], 'blue'; ...
                  'ybar', [at, measured, measured - sd, measured + sd], ...
                  'ink'});
end

%!test
%! % a curve over where it was measured, in its unit
%! page = situationPage ('missed, named');
%! page.Case.targets = struct ('name', {'w@1', 'w@2', 'w@3', 'x'}, ...
%!   'modelName', 'First', 'model', 1, 'index', {1, 2, 3, 4}, 'result', 'w', ...
%!   'series', {'w', 'w', 'w', ''}, 'at', {1, 2, 3, NaN}, 'unit', 'kg m-3');
%! page.targets = struct ('label', repmat ({''}, 1, 4), 'unit', 'kg m-3');
%! page.sources.gap.where.targets = struct ('model', 'First', 'name', ...
%!   {'w@3', 'w@2', 'w@1', 'x'}, 'measured', 7, 'predicted', 8, 'z', 3.5, 'p', 0.01, ...
%!   'sdMeasured', 0.1, 'sdPredicted', 0.5);
%! page.tables = statementTables (page, {'where'});
%! where = sectionWhere (){3};
%! html = where (page);
%! assert (numel (strfind (html, '<figcaption>')), 1);
%! for text = {'First: w: measured and simulated at 3 points', 'kg m-3', ...
%!             'class="off"'}
%!   assert (! isempty (strfind (html, text{1})));
%! end
%! % two points are no curve
%! page.sources.gap.where.targets(1) = [];
%! assert (isempty (strfind (where (page), '<figcaption>')));
