% SECTIONWHERE  Part of the report: where the measurements are missed.
%
% CALL: LIST = sectionWhere (), see writePage

function list = sectionWhere ()
  list = {'sectionwhere', 'Where the model misses', @where, ...
          {'sources', 'gap', 'where', 'targets'}};
end

function html = where (page)
  found = page.sources.gap.where;
  html = [leadIn(page, found), curves(page), targetTable(page, found), ...
          hidden(page, found)];
end

function html = leadIn (page, where)
  models = {'the calibrated model', 'what the reference foretells'};
  never = namesIn (where, 'neverRun');
  lists = {'To come this close the parameters go to their limit', ...
           namesIn(where, 'atLimit'); ...
           'None of its runs gave a result, so it takes no part', ...
           setdiff(namesIn (where, 'out'), never); ...
           'It was never run to its end, so it takes no part', never};
  html = ['<p>Noise alone would make ', models{1 + page.isChange}, ...
          ' miss these measurements by as much with p&nbsp;=&nbsp;', ...
          pageNumber(page, 'plain', 'gap', 'where', 'p'), '.'];
  for one = lists(~cellfun (@isempty, lists(:, 2)), :)'
    html = [html, ' ', one{1}, ': ', ...
            htmlText(strjoin (one{2}(:)', ', ')), '.'];
  end
  if isfield (where, 'surrogateShare')
    html = [html, ' Of the noise, ', ...
            pageNumber(page, 'percent', 'gap', 'where', 'surrogateShare'), ...
            ' is the uncertainty of the surrogates.'];
  end
  html = [html, '</p>'];
end

function html = targetTable (page, where)
  html = htmlTable (['All targets of the diagnosis; misses beyond 2 are ', ...
                     'coloured, beyond 3 strongly; p: how often noise ', ...
                     'alone makes one of the fitted (or held-out) ones as ', ...
                     'odd'], ...
                    {'target', 'role', 'measured', '&plusmn; (sd)', ...
                     'simulated', 'miss / noise', 'p', ...
                     'parameters cannot hide', 'remark'}, ...
                    @(t) targetRow (page, jsonAt (where.targets, {t}), t), ...
                    numel (where.targets));
end

function cells = targetRow (page, target, t)
  at = @(kind, field) pageNumber (page, kind, 'gap', 'where', 'targets', t, ...
                                  field);
  numbers = repmat ({'&ndash;'}, 1, 3);
  row = targetAt (page.sources.gapTargets, target);
  if ~isempty (row)
    numbers = cellfun (@(field) pageNumber (page, 'plain', 'gapTargets', ...
                                            row, field), ...
                       {'measured', 'sd_measured', 'predicted'}, ...
                       'UniformOutput', false);
  end
  remark = '';
  if isequal (jsonAt (target, {'p'}) < 0.05, true)
    remark = '<span class="off">off</span>';
  elseif isequal (jsonAt (target, {'blind'}), true)
    remark = '<span class="unsure">blind: parameters can hide an error</span>';
  end
  cells = {htmlText([target.model, ': ', target.name]), ...
           htmlText(target.role), numbers{:}, ...
           sprintf('<span class="z%d">%s</span>', ...
                   sum (max ([abs(target.z), 0]) >= 1:3), at ('z', 'z')), ...
           at('plain', 'p'), at('percent', 'unabsorbed'), remark};
end

function html = hidden (page, where)
  html = '';
  params = jsonAt (where, {'params'});
  if ~isstruct (params)
    return
  end
  names = fieldnames (params);
  cells = cell (numel (names), 4);
  for k = 1:numel (names)
    box = page.Case.limits(1:2, strcmp (names{k}, page.Case.names))(:)';
    box = arrayfun (@numberText, box, 'UniformOutput', false);
    box(end + 1:2) = {''};
    cells(k, :) = {htmlText(names{k}), ...
                   pageNumber(page, 'plain', 'gap', 'where', 'params', ...
                              names{k}), box{:}};
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
function html = curves (page)
  html = '';
  figures = [];
  table = onSeries (page.sources.gapTargets, page);
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

% The rows that belong to a series, with series, at and unit.
function table = onSeries (rows, page)
  table = [];
  info = targetInfo (page.Case);
  for row = rows(:)'
    t = targetAt (page.Case.targets, row);
    if ~isempty (t) && ~isempty (info(t).series) && isfinite (info(t).at)
      [row.series, row.at] = deal (info(t).series, info(t).at);
      row.unit = page.units{t};
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
  sd = [points.sd_measured]';
  noise = 1.64 * hypot ([points.sd_trial]', [points.sd_surrogate]');
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
%! page.units = repmat ({'kg m-3'}, 1, 4);
%! page.sources.gapTargets = struct ('model', 'First', 'name', ...
%!   {'w@3', 'w@2', 'w@1', 'x'}, 'measured', 7, 'predicted', 8, ...
%!   'sd_measured', 0.1, 'sd_trial', 0.3, 'sd_surrogate', 0.4);
%! where = sectionWhere (){3};
%! html = where (page);
%! assert (numel (strfind (html, '<figcaption>')), 1);
%! for text = {'First: w: measured and simulated at 3 points', 'kg m-3', ...
%!             'First: sum', '<span class="off">off</span>'}
%!   assert (! isempty (strfind (html, text{1})), text{1});
%! end
%! % two points are no curve
%! page.sources.gapTargets(1) = [];
%! assert (isempty (strfind (where (page), '<figcaption>')));
