% SECTIONTARGETS  Parts of the report: the targets and how they are met; how the
% residuals came down.
%
% CALL: LIST = sectionTargets (), see writePage

function list = sectionTargets ()
  list = {'sectiontargets', 'Targets', @targets, {}; ...
          'sectionsteps', 'Steps after the plan', @steps, {}};
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

function html = steps (page)
  html = '';
  sources = {'calibration', 'progress'};
  source = sources{1 + isempty(page.sources.calibration)};
  list = jsonList (page.sources, {source, 'history'});
  n = numel (list);
  if n < 1
    return
  end
  figures = {};
  if n > 2
    R = [eachOf(@(s) s.residual(:), list){:}];
    runs = cellfun (@(s) s.runs, list);
    figures = eachOf (@(t) stepFigure (page, t, runs, 100 * R(t, :)), ...
                      shownTargets (page.Case));
  end
  key = {'area', 'palegreen', 'tolerance'; ...
         'area', 'palegrey', 'scatter of one run (1 sd)'; ...
         'disc', 'blue', 'residual (fitted surfaces, corrected by the runs)'};
  at = @(field, k) {source, 'history', k, field};
  row = @(k) {sprintf('%s %d', sentence (['stage.', list{k}.stage]), list{k}.iteration), ...
              at('runs', k), at('probability', k)};
  html = [htmlFigures([figures{:}], key), ...
          tableHtml(newTable (page, 'steps', 'Steps', ...
                              {'step', '', ''; 'parameter values run so far, repeats counted', ...
                               '', 'count'; 'chance that all targets are met', '', ...
                               'probability'}, eachOf (row, 1:n)))];
end

function f = stepFigure (page, t, runs, r)
  T = page.Case.targets(t);
  width = [min(runs) - 0.5; max(runs) + 0.5];
  noise = 0;
  if ~isempty (page.surrogates)
    noise = 100 * sqrt (page.surrogates(t).noiseVar) * T.tol / halfWidth (T);
  end
  band = @(half, colour) {'area', [width, half * [-1, 1; -1, 1]], colour};
  bands = [band(noise, 'palegrey'); band(100 * T.tol, 'palegreen')];
  if 100 * T.tol > noise                % the narrower one in front
    bands = flipud (bands);
  end
  f = newFigure (T.name, 'runs after the plan', ...
                 'residual (%)', ...
                 sprintf (['%s: residual %.3g %% after the first step, ', ...
                           '%.3g %% now'], T.name, r(1), r(end)), ...
                 [bands; {'dash', [width, [0; 0]], 'grey'; ...
                          'line', [runs(:), r(:)], 'blue'; ...
                          'disc', [runs(:), r(:)], 'blue'}]);
  f.xlim = width';
  f.whole = true;
end

%!test
%! % three targets, one of them not measured yet
%! page = situationPage ('met');
%! page.sources.calibration.history = ...
%!   struct ('stage', {'infill', 'DEM', 'DEM'}, 'iteration', {1, 1, 2}, ...
%!           'runs', {1, 2, 4}, 'probability', {0.1, 0.5, 0.9}, ...
%!           'residual', {[0.1; 0.2; NaN], [0.05; 0.1; NaN], [0.01; 0; NaN]});
%! html = sectionTargets (){2, 3} (page);
%! assert (numel (strfind (html, '<svg viewBox="0 0 340')), 3);
%! assert (! isempty (strfind (html, 'stage on DEM 2')));
