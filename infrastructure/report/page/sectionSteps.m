% SECTIONSTEPS  Part of the report: how the residuals came down.
%
% CALL: [TITLE, HTML] = sectionSteps (PAGE), see writePage and pageData

function [title, html] = sectionSteps (page)
  title = 'Steps after the plan';
  html = '';
  source = 'calibration';
  if isempty (page.sources.calibration)
    source = 'progress';
  end
  history = jsonAt (page.sources, {source, 'history'});
  if isempty (history)
    return
  end
  n = numel (history);
  steps = arrayfun (@(k) jsonAt (history, {k}), 1:n, 'UniformOutput', false);
  R = cellfun (@(s) asNumbers (s.residual), steps, 'UniformOutput', false);
  R = [R{:}];
  runs = cellfun (@(s) s.runs, steps);
  figures = [];
  if n > 2
    for t = shownTargets (page.Case)
      figures = [figures, stepFigure(page, t, runs, R(t, :))];
    end
  end
  key = htmlKey ({'area', 'palegreen', 'tolerance'; ...
                  'area', 'palegrey', 'scatter of one run (1 sd)'; ...
                  'disc', 'blue', ['residual of the set in hand ', ...
                                   '(surrogates, corrected by the runs)']});
  html = [htmlFigures(figures, key), stepTable(page, source, n)];
end

% null stands for a target that is not measured yet.
function r = asNumbers (r)
  if iscell (r)
    r(cellfun (@isempty, r)) = {NaN};
    r = [r{:}];
  end
  r = r(:);
end

function f = stepFigure (page, t, runs, r)
  T = page.Case.targets(t);
  f = newFigure (T.name, 'parameter sets run after the plan', ...
                 'residual (%)', '');
  f.alt = sprintf ('%s: residual %.3g %% after the first step, %.3g %% now', ...
                   T.name, 100 * r(1), 100 * r(end));
  width = [min(runs) - 0.5; max(runs) + 0.5];
  noise = 0;
  if ~isempty (page.surrogates)
    noise = 100 * sqrt (page.surrogates(t).noiseVar) * T.tol / halfWidth (T);
  end
  bands = [noise, 100 * T.tol];
  colours = {'palegrey', 'palegreen'};
  for k = 1 + [bands(2) > bands(1), bands(2) <= bands(1)]
    f = addLayer (f, 'area', [width, bands(k) * [-1, 1; -1, 1]], colours{k});
  end
  f = addLayer (f, 'dash', [width, [0; 0]], 'grey');
  f = addLayer (f, 'line', [runs(:), 100 * r(:)], 'blue');
  f = addLayer (f, 'disc', [runs(:), 100 * r(:)], 'blue');
  f.xlim = width';
  f.whole = true;
end

function html = stepTable (page, source, n)
  cells = cell (n, 4);
  words = struct ('infill', 'infill', 'DEM', 'stage on DEM');
  for k = 1:n
    s = jsonAt (page.sources, {source, 'history', k});
    stage = s.stage;
    if isfield (words, stage)
      stage = words.(stage);
    end
    cells(k, :) = {sprintf('%s %d', htmlText (stage), s.iteration), ...
                   pageNumber(page, 'count', source, 'history', k, 'runs'), ...
                   pageNumber(page, 'probability', source, 'history', k, ...
                              'probability'), ...
                   residuals(page, source, k, shownTargets (page.Case))};
  end
  html = htmlTable ('Steps', {'step', 'sets run so far, repeats counted', ...
                              'chance that all targets are met', ...
                              'residuals, in the order of the targets'}, cells);
end

function html = residuals (page, source, k, shown)
  parts = arrayfun (@(t) pageNumber (page, 'percent', source, 'history', k, ...
                                     'residual', t), shown, ...
                    'UniformOutput', false);
  html = strjoin (parts, ', ');
end

%!test
%! % three targets, one of them not measured yet (null)
%! page = situationPage ('met');
%! page.sources.calibration.history = ...
%!   struct ('stage', {'infill', 'DEM', 'DEM'}, 'iteration', {1, 1, 2}, ...
%!           'runs', {1, 2, 4}, 'probability', {0.1, 0.5, 0.9}, ...
%!           'residual', {{0.1; 0.2; []}, {0.05; 0.1; []}, {0.01; 0; []}});
%! [~, html] = sectionSteps (page);
%! assert (numel (strfind (html, '<svg viewBox="0 0 340')), 3);
%! assert (! isempty (strfind (html, 'stage on DEM 2')));
