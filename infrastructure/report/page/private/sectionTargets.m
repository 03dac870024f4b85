% SECTIONTARGETS  Part of the report: the targets and how they are met.
%
% CALL: LIST = sectionTargets (), see writePage

function list = sectionTargets ()
  list = {'sectiontargets', 'Targets', @targets, {}};
end

function html = targets (page)
  c = page.sources.calibration;
  if isempty (c)
    % the diagnosis has a table of its own
    html = repmat (tableHtml (page.tables.targets), 1, isempty (page.sources.gap));
    return
  end
  [figures, key] = deal ([], {});
  names = {page.Case.models.name};
  for name = names(~strcmp (names, page.verdict.worst))
    [f, key] = benchFigure (page, name{1});     % the worst one stands on top
    figures = [figures, f];
  end
  html = [htmlFigures(figures, key), curves(page), tableHtml(page.tables.targets), ...
          predictions(page, jsonList (c, {'holdout'}))];
end

function html = curves (page)
  list = curveSummary (page.Case, zeros (1, numel (page.Case.targets)));
  html = htmlFigures ([eachOf(@(one) curveFigure (page, one.own), list){:}], ...
                      {'area', 'palegreen', 'allowed'; 'dots', 'ink', 'measured'; ...
                       'line', 'blue', 'simulated'; 'area', 'midblue', 'its 90 % interval'});
end

% A measured curve and what the found set gives; POINTS  numbers of targets.
function f = curveFigure (page, points)
  [at, order] = sort ([page.Case.targets(points).at]');
  points = points(order);
  T = page.Case.targets(points);
  read = @(field) vertcat (eachOf (@(t) jsonAt (page.sources.calibration, ...
                                                {'targets', t, field})(:)', points){:});
  [half, value] = deal (arrayfun (@halfWidth, T)', [T.value]');
  [simulated, range] = deal (read ('result'), read ('interval90'));
  alt = sprintf (['%s: measured and found at %d points, from %.4g and ', ...
                  '%.4g to %.4g and %.4g'], T(1).series, numel (at), ...
                 value(1), simulated(1), value(end), simulated(end));
  f = newFigure (sprintf ('%s: %s', T(1).modelName, T(1).series), ...
                 'where it was measured', page.targets(points(1)).unit, alt, ...
                 {'area', [at, value - half, value + half], 'palegreen'; ...
                  'area', [at(1:rows (range)), range], 'midblue'; ...
                  'line', [at, simulated], 'blue'; ...
                  'dots', [at, value], 'ink'});
end

% What nobody has measured yet.
function html = predictions (page, held)
  row = @(k) {held{k}.name, {'calibration', 'holdout', k, 'result'}, ...
              {'calibration', 'holdout', k, 'interval90'}};
  open = find (cellfun (@(h) isempty (h.inside), held));
  html = tableHtml (newTable (page, 'predictions', ...
                              'Not measured yet: what these values predict', ...
                              {'result', '', ''; 'predicted', '', 'plain'; ...
                               '90 % interval of a measurement', '', 'plain'}, ...
                              eachOf (row, open)));
end

% SPDX-License-Identifier: GPL-3.0-only
