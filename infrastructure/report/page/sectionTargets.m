% SECTIONTARGETS  Parts of the report: the targets and how they are met; how the
% residuals came down.
%
% CALL: LIST = sectionTargets (), see writePage

function list = sectionTargets ()
  list = {'sectiontargets', 'Targets', @targets, {}; ...
          'sectionsteps', 'Steps after the plan', @steps, {}};
end

function html = targets (page)
  html = '';
  c = page.sources.calibration;
  if isempty (c)
    % the diagnosis has a table of its own
    html = tableHtml (page.tables.targets)(1:end * isempty (page.sources.gap));
    return
  end
  [figures, key] = deal ([], {});
  names = {page.Case.models.name};
  for name = names(~strcmp (names, page.verdict.worst))
    [f, key] = benchFigure (page, name{1});     % the worst one stands on top
    figures = [figures, f];
  end
  html = [htmlFigures(figures, key), curves(page), tableHtml(page.tables.targets), ...
          predictions(page)];
end

function html = curves (page)
  list = curveSummary (page.Case, zeros (1, numel (page.Case.targets)));
  figures = arrayfun (@(one) curveFigure (page, one.own), list, ...
                      'UniformOutput', false);
  html = htmlFigures ([figures{:}], {'area', 'palegreen', 'allowed'; ...
                                     'dots', 'ink', 'measured'; ...
                                     'line', 'blue', 'simulated'; ...
                                     'area', 'midblue', 'its 90 % interval'});
end

% A measured curve and what the found set gives; POINTS  numbers of targets.
function f = curveFigure (page, points)
  [at, order] = sort ([page.Case.targets(points).at]);
  points = points(order);
  T = page.Case.targets(points);
  at = at(:);
  read = @(field) arrayfun (@(t) jsonAt (page.sources.calibration, ...
                                         {'targets', t, field})(:)', ...
                            points(:), 'UniformOutput', false);
  simulated = vertcat (read ('result'){:});
  half = arrayfun (@halfWidth, T)';
  value = [T.value]';
  alt = sprintf (['%s: measured and found at %d points, from %.4g and ', ...
                  '%.4g to %.4g and %.4g'], T(1).series, numel (at), ...
                 value(1), simulated(1), value(end), simulated(end));
  f = newFigure (sprintf ('%s: %s', T(1).modelName, T(1).series), ...
                 'where it was measured', page.targets(points(1)).unit, alt, ...
                 {'area', [at, value - half, value + half], 'palegreen'; ...
                  'area', [at, vertcat(read ('interval90'){:})], 'midblue'; ...
                  'line', [at, simulated], 'blue'; ...
                  'dots', [at, value], 'ink'});
  if columns (f.layers{2, 2}) < 3       % an older file
    f.layers(2, :) = [];
  end
end

% What nobody has measured yet.
function html = predictions (page)
  held = jsonAt (page.sources.calibration, {'holdout'});
  open = find (arrayfun (@(k) isempty (jsonAt (held, {k, 'inside'})), ...
                         1:numel (held)));
  cells = arrayfun (@(k) {jsonAt(held, {k, 'name'}), ...
                          {'calibration', 'holdout', k, 'result'}, ...
                          {'calibration', 'holdout', k, 'interval90'}}, open, ...
                    'UniformOutput', false);
  html = tableHtml (newTable (page, 'predictions', ...
                              'Not measured yet: what these values predict', ...
                              {'result', '', ''; 'predicted', '', 'plain'; ...
                               '90 % interval of a measurement', '', 'plain'}, ...
                              vertcat (cell (0, 3), cells{:})));
end

function html = steps (page)
  html = '';
  source = 'calibration';
  if isempty (page.sources.calibration)
    source = 'progress';
  end
  history = jsonAt (page.sources, {source, 'history'});
  n = numel (history);
  if n < 1
    return
  end
  list = arrayfun (@(k) jsonAt (history, {k}), 1:n, 'UniformOutput', false);
  figures = [];
  if n > 2
    R = cellfun (@(s) s.residual(:), list, 'UniformOutput', false);
    R = [R{:}];
    runs = cellfun (@(s) s.runs, list);
    for t = shownTargets (page.Case)
      figures = [figures, stepFigure(page, t, runs, 100 * R(t, :))];
    end
  end
  key = {'area', 'palegreen', 'tolerance'; ...
         'area', 'palegrey', 'scatter of one run (1 sd)'; ...
         'disc', 'blue', ['residual (fitted surfaces, ', ...
                          'corrected by the runs)']};
  cells = arrayfun (@(k) stepRow (page, source, list{k}, k), 1:n, 'UniformOutput', false);
  html = [htmlFigures(figures, key), ...
          tableHtml(newTable (page, 'steps', 'Steps', ...
                              {'step', '', ''; 'sets run so far, repeats counted', '', ...
                               'count'; 'chance that all targets are met', '', ...
                               'probability'}, vertcat (cells{:})))];
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
  f = newFigure (T.name, 'parameter sets run after the plan', ...
                 'residual (%)', ...
                 sprintf (['%s: residual %.3g %% after the first step, ', ...
                           '%.3g %% now'], T.name, r(1), r(end)), ...
                 [bands; {'dash', [width, [0; 0]], 'grey'; ...
                          'line', [runs(:), r(:)], 'blue'; ...
                          'disc', [runs(:), r(:)], 'blue'}]);
  f.xlim = width';
  f.whole = true;
end

function cells = stepRow (page, source, step, k)
  at = @(field) {source, 'history', k, field};
  stage = step.stage;
  if strcmp (stage, 'DEM')
    stage = sentence ('table.stageDEM');
  end
  name = sprintf ('%s %d', stage, step.iteration);
  cells = {name, at('runs'), at('probability')};
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
