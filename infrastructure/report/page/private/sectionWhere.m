% SECTIONWHERE  Part of the report: where the measurements are missed.
%
% CALL: LIST = sectionWhere (), see writePage

function list = sectionWhere ()
  list = {'sectionwhere', {'Where the model misses', 'Where it has changed'}, @where, ...
          {'sources', 'gap', 'where', 'targets'}};
end

function html = where (page)
  found = page.sources.gap.where;
  p = plainNumber (jsonAt (found, {'p'}), 'p');
  html = ['<p>', htmlText(sentence ('where.chance', struct ('p', p), page.isChange)), '</p>', ...
          seriesFigures(page), tableHtml(page.tables.where), fitted(page, found)];
end

function html = fitted (page, where)
  names = page.Case.names(isfield (jsonAt (where, {'params'}), page.Case.names));
  row = @(n) {n, {'gap', 'where', 'params', n}, ...
              page.Case.limits(1:2, strcmp (n, page.Case.names))};
  note = {sentence('table.twoSets')};
  html = tableHtml (newTable (page, 'fitted', ...
                              'Parameters of the best fit without any cause', ...
                              {'parameter', '', ''; 'value', '', 'plain'; ...
                               'limits', '', 'plain'}, eachOf (row, names), ...
                              note(~isempty (page.sources.calibration))));
end

% Results of one series (results.csv of the model) as a curve over where they
% were measured.
function html = seriesFigures (page)
  html = '';
  points = onSeries (page);
  figures = [];
  for name = unique ({points.title}, 'stable')
    series = points(strcmp ({points.title}, name{1}));
    if numel (series) > 2
      figures = [figures, seriesFigure(series, name{1})];
    end
  end
  if ~isempty (figures)
    key = {'ybar', 'ink', 'measured &plusmn; 1 sd'; ...
           'line', 'blue', 'simulated with the fitted parameters'; ...
           'area', 'paleblue', 'its noise (90 %: packing and surrogate)'};
    html = ['<h3>Measured against simulated</h3>', htmlFigures(figures, key)];
  end
end

% The targets that belong to a series, with title of the figure, at and unit.
function points = onSeries (page)
  points = struct ('title', {}, 'at', {}, 'unit', {}, 'T', {});
  info = targetInfo (page.Case);
  for target = jsonList (page.sources.gap, {'where', 'targets'})
    t = targetAt (page.Case.targets, target{1});
    if ~isempty (t) && ~isempty (info(t).series) && isfinite (info(t).at) && ...
       ~isempty (jsonAt (target{1}, {'predicted'}))
      points(end + 1) = struct ('title', [target{1}.model, ': ', info(t).series], ...
                                'at', info(t).at, 'unit', page.targets(t).unit, ...
                                'T', target{1});
    end
  end
end

function f = seriesFigure (points, title)
  [at, order] = sort ([points.at]');
  of = @(field) arrayfun (@(p) p.T.(field), points(order))';
  [measured, simulated, sd] = deal (of ('measured'), of ('predicted'), of ('sdMeasured'));
  noise = 1.64 * of ('sdPredicted');
  f = newFigure (title, 'where it was measured', points(1).unit, ...
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
%!   'series', {'w', 'w', 'w', ''}, 'at', {1, 2, 3, NaN}, 'unit', 'kg m-3', ...
%!   'shown', struct ('unit', '', 'factor', 1));
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

% SPDX-License-Identifier: GPL-3.0-only
