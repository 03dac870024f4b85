% SECTIONTARGETS  Parts of the report: the targets and how they are met; how the
% residuals came down.
%
% CALL: LIST = sectionTargets (), see writePage

function list = sectionTargets ()
  list = {'sectiontargets', 'Targets', @targets, {}; ...
          'sectionsteps', 'Steps after the plan', @steps, {}};
end

function html = targets (page)
  if isempty (page.sources.calibration)
    html = askedFor (page);
    return
  end
  [figures, key] = deal ([], {});
  names = {page.Case.models.name};
  for name = names(~strcmp (names, page.verdict.worst))
    [f, key] = benchFigure (page, name{1});     % the worst one stands on top
    figures = [figures, f];
  end
  html = [htmlFigures(figures, key), curves(page), resultTable(page), ...
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
                 'where it was measured', page.units{points(1)}, alt, ...
                 {'area', [at, value - half, value + half], 'palegreen'; ...
                  'area', [at, vertcat(read ('interval90'){:})], 'midblue'; ...
                  'line', [at, simulated], 'blue'; ...
                  'dots', [at, value], 'ink'});
  if columns (f.layers{2, 2}) < 3       % an older file
    f.layers(2, :) = [];
  end
end

function html = askedFor (page)
  html = '';
  targets = page.Case.targets;
  if isempty (page.sources.gap)         % the diagnosis has a table of its own
    kinds = {'percent', 'plain'};
    row = @(t) {nameOf(page, t), htmlText(targets(t).modelName), ...
                numberText(targets(t).value), numberText(targets(t).sd), ...
                numberText(targets(t).tol, kinds{1 + targets(t).isAbsolute})};
    html = htmlTable ('What is to be met; there is no result yet', ...
                      {'target', 'model', 'measured', 'uncertainty (sd)', ...
                       'tolerance'}, row, numel (targets));
  end
end

function text = nameOf (page, t)
  words = struct ('calibrate', '', 'holdout', ', held out', ...
                  'unmeasured', ', not measured yet');
  T = page.Case.targets(t);
  text = [htmlText(withUnit (T.name, page.units{t})), words.(T.role)];
end

% One row a target; a curve is one, as decideCase has it.
function html = resultTable (page)
  misses = page.verdict.misses;
  misses = misses(~strcmp ({misses.role}, 'unmeasured'));
  head = {'target', '<span class="words short">met?</span>', 'measured', ...
          meanHead(page), 'all runs together', 'allowed &plusmn;', ...
          'with the effect', 'the box reaches'};
  shown = [1:6, 8];
  why = '';
  if page.showsEffect && ...
     ~isempty (jsonAt (page.sources.gap, {'howFar', 'targets'}))
    shown = 1:8;
    why = ['<p>With the effect: ', lower(whyTwoSets ()(1)), ...
           whyTwoSets()(2:end), '</p>'];
  end
  html = [htmlTable(['Measured and simulated, the largest miss first; ', ...
                     'allowed of a held-out target: where a measurement ', ...
                     'lies in 90&thinsp;% of cases'], head(shown), ...
                    @(k) resultRow (page, misses(k))(shown), ...
                    numel (misses)), why];
end

function cells = resultRow (page, m)
  t = targetAt (page.Case.targets, m);
  place = [' <span class="none">', htmlText(m.model)];
  if isempty (t)
    cells = {[htmlText(m.name), place, ', curve</span>'], metWord(m), '', ...
             '', '', '', '', [numberText(m.share), ' times what is allowed']};
    return
  end
  at = @(field) pageNumber (page, 'plain', 'calibration', 'targets', t, field);
  simulated = 'estimate';
  if isempty (jsonAt (page.sources.calibration, {'targets', t, simulated}))
    simulated = 'result';
  end
  cure = {'howFar', 'targets'};
  k = targetAt (jsonAt (page.sources.gap, cure), m);
  cells = {[nameOf(page, t), place, '</span>'], metWord(m), at('target'), ...
           at('result'), at(simulated), numberText(m.allowed), ...
           pageNumber(page, 'plain', 'gap', cure{:}, k, 'after'), ...
           [numberText(page.reach(t, 1)), ' to ', ...
            numberText(page.reach(t, 2))]};
end

function text = meanHead (page)
  n = jsonAt (page.sources.calibration, {'runs'});
  text = 'DEM, no run there';
  if isequal (n, 1)
    text = 'DEM, one run';
  elseif ~isempty (n) && n > 0
    text = sprintf ('DEM, mean of %d runs', n);
  end
end

function html = metWord (m)
  [class, word] = deal ('', 'not measured');
  [~, open] = missTexts (m);
  if ~isempty (open)
    word = ['open: ', open];
  elseif m.met == 0
    [class, word] = deal (' off', 'missed');
  elseif m.met == 1 && strcmp (m.role, 'holdout')
    [class, word] = deal (' ok', 'predicted');
  elseif m.met == 1
    [class, word] = deal (' ok', 'met');
  end
  html = sprintf ('<span class="words short%s">%s</span>', class, word);
end

% What nobody has measured yet.
function html = predictions (page)
  held = jsonAt (page.sources.calibration, {'holdout'});
  open = find (arrayfun (@(k) isempty (jsonAt (held, {k, 'inside'})), ...
                         1:numel (held)));
  at = @(k, field) pageNumber (page, 'plain', 'calibration', 'holdout', k, ...
                               field);
  row = @(k) {htmlText(jsonAt (held, {k, 'name'})), at(k, 'result'), ...
              at(k, 'interval90')};
  html = htmlTable ('Not measured yet: what the set predicts', ...
                    {'target', 'predicted', ...
                     '90&thinsp;% interval of a measurement'}, ...
                    @(i) row (open(i)), numel (open));
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
         'disc', 'blue', ['residual of the set in hand (surrogates, ', ...
                          'corrected by the runs)']};
  html = [htmlFigures(figures, key), ...
          htmlTable('Steps', {'step', 'sets run so far, repeats counted', ...
                              'chance that all targets are met', ...
                              'residuals, in the order of the targets'}, ...
                    @(k) stepRow (page, source, list{k}, k), n)];
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
  at = @(kind, varargin) pageNumber (page, kind, source, 'history', k, ...
                                     varargin{:});
  residuals = arrayfun (@(t) at ('percent', 'residual', t), ...
                        shownTargets (page.Case), 'UniformOutput', false);
  cells = {sprintf('%s %d', regexprep (htmlText (step.stage), '^DEM$', ...
                                       'stage on DEM'), step.iteration), ...
           at('count', 'runs'), at('probability', 'probability'), ...
           strjoin(residuals, ', ')};
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
