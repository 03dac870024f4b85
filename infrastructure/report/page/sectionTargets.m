% SECTIONTARGETS  Part of the report: the targets and how they are met.
%
% CALL: [TITLE, HTML] = sectionTargets (PAGE)
%
%   PAGE  see pageData; TITLE, HTML  see pageSections
%
% See also: pageSections

function [title, html] = sectionTargets (page)
  title = 'Targets';
  targets = page.Case.targets;
  isHeld = ~strcmp ({targets.role}, 'calibrate');
  if isempty (page.sources.calibration)
    html = askedFor (page);
    return
  end
  figures = [];
  curves = curveSummary (page.Case, zeros (1, numel (targets)));
  inCurve = ismember (1:numel (targets), [curves.own]);
  for t = find (~isHeld & ~inCurve)
    figures = [figures, bullet(page, t)];
  end
  for c = curves
    figures = [figures, targetCurve(page, c.own)];
  end
  key = htmlKey ({'box', 'palegreen', 'tolerance'; ...
                  'line', 'ink', 'measured'; ...
                  'box', 'midblue', ...
                  '90 % interval of the mean response at the set'; ...
                  'xbar', 'grey', 'scatter of one run (1 sd)'; ...
                  'diamond', 'blue', resultWord(page)});
  html = [htmlFigures(figures, key), curveTable(page), ...
          resultTable(page, find (~isHeld & ~inCurve))];
  if any (isHeld)
    html = [html, heldOut(page)];
  end
end

function text = resultWord (page)
  text = 'result (mean of the DEM runs)';
  if isequal (jsonAt (page.sources.calibration, {'runs'}), 0)
    text = 'result (of the surrogates: no DEM run was made at the set)';
  end
end

function html = askedFor (page)
  html = '';
  if ~isempty (page.sources.gap)
    return                  % the diagnosis has a table of its own
  end
  targets = page.Case.targets;
  cells = cell (numel (targets), 5);
  for t = 1:numel (targets)
    T = targets(t);
    cells(t, :) = {nameOf(page, t), htmlText(T.modelName), ...
                   numberText(T.value), numberText(T.sd), ...
                   numberText(T.tol, 'percent')};
    if isAbsolute (T)
      cells{t, 5} = numberText (T.tol, 'plain');
    end
  end
  html = htmlTable ('What is to be met; there is no result yet', ...
                    {'target', 'model', 'measured', 'uncertainty (sd)', ...
                     'tolerance'}, cells);
end

function text = nameOf (page, t)
  text = htmlText (withUnit (page.Case.targets(t).name, page.units{t}));
  role = page.Case.targets(t).role;
  if strcmp (role, 'holdout')
    text = [text, ', held out'];
  elseif strcmp (role, 'unmeasured')
    text = [text, ', not measured yet'];
  end
end

function f = bullet (page, t)
  T = page.Case.targets(t);
  r = jsonAt (page.sources.calibration, {'targets', t});
  alt = sprintf ('%s: measured %.4g, result %.4g, tolerance %.3g', ...
                 T.name, r.target, r.result, halfWidth (T));
  f = newFigure (withUnit (T.name, page.units{t}), '', '', alt);
  f.size = [340, 70];
  f.ylim = [0, 1];
  f.ynames = {' '};
  half = halfWidth (T);
  f = addLayer (f, 'box', [r.target, 0.5, r.target + [-half, half], ...
                           0.08, 0.92], 'palegreen');
  if isfield (r, 'interval90')
    f = addLayer (f, 'box', [r.result, 0.5, r.interval90(:)', 0.36, 0.64], ...
                  'midblue');
  end
  f = addLayer (f, 'line', [r.target, 0.02; r.target, 0.98], 'ink');
  f = addLayer (f, 'xbar', [r.result, 0.5, ...
                            r.result + r.noiseSd * [-1, 1]], 'grey');
  f = addLayer (f, 'diamond', [r.result, 0.5], 'blue');
end

% A curve is met as a whole, see toleranceShare.
function html = curveTable (page)
  html = '';
  R = arrayfun (@(t) jsonAt (page.sources.calibration, ...
                             {'targets', t, 'residual'}), ...
                1:numel (page.Case.targets), 'UniformOutput', false);
  R(cellfun (@isempty, R)) = {NaN};
  curves = curveSummary (page.Case, [R{:}]);
  if isempty (curves)
    return
  end
  cells = cell (numel (curves), 5);
  for k = 1:numel (curves)
    c = curves(k);
    verdict = '<span class="ok">met</span>';
    if ~isMet (page, struct ('model', c.model, 'name', c.name))
      verdict = '<span class="off">not met</span>';
    end
    cells(k, :) = {htmlText(c.name), htmlText(c.model), ...
                   sprintf('%d', numel (c.own)), ...
                   numberText(c.share, 'plain'), verdict};
  end
  html = htmlTable (['Curves: root mean square of the deviations, each ' ...
                     'over its tolerance; met up to 1'], ...
                    {'curve', 'model', 'points', ...
                     'deviation over tolerance', 'verdict'}, cells);
end

function html = resultTable (page, which)
  html = '';
  if isempty (which)
    return
  end
  cells = cell (numel (which), 8);
  for k = 1:numel (which)
    t = which(k);
    r = jsonAt (page.sources.calibration, {'targets', t});
    at = @(kind, field) pageNumber (page, kind, 'calibration', 'targets', ...
                                    t, field);
    verdict = '<span class="ok">met</span>';
    if ~isMet (page, r)
      verdict = '<span class="off">not met</span>';
    end
    kind = 'percent';
    if isAbsolute (page.Case.targets(t))
      kind = 'plain';
    end
    cells(k, :) = {nameOf(page, t), at('plain', 'target'), ...
                   at('plain', 'result'), at(kind, 'residual'), ...
                   at(kind, 'tol'), verdict, at('plain', 'noiseSd'), ...
                   pageInterval(page, 'plain', 'calibration', ...
                                'targets', t, 'interval90')};
  end
  html = htmlTable ('Targets and results at the set that was found', ...
                    {'target', 'measured', 'result', 'deviation', ...
                     'tolerance', 'verdict', 'one run &plusmn; (sd)', ...
                     '90&thinsp;% interval of the mean'}, cells);
end

% As decideCase has decided.
function yes = isMet (page, target)
  all = page.verdict.misses;
  yes = any ([all(strcmp ({all.model}, target.model) & ...
                  strcmp ({all.name}, target.name)).met] == 1);
end

function html = heldOut (page)
  held = jsonAt (page.sources.calibration, {'holdout'});
  cells = cell (numel (held), 5);
  for k = 1:numel (held)
    h = jsonAt (held, {k});
    at = @(field) pageNumber (page, 'plain', 'calibration', 'holdout', k, ...
                              field);
    verdict = '<span class="ok">inside</span>';
    if isempty (h.inside)
      verdict = 'not measured yet';
    elseif ~h.inside
      verdict = '<span class="off">outside</span>';
    end
    cells(k, :) = {htmlText(h.name), at('target'), at('result'), ...
                   pageInterval(page, 'plain', 'calibration', ...
                                'holdout', k, 'interval90'), verdict};
  end
  html = ['<h3>Held-out targets</h3><p>Never used in the fit: they show ', ...
          'whether the set predicts what it was not fitted to.</p>', ...
          htmlTable('Held-out targets: predicted and measured', ...
                    {'target', 'measured', 'predicted', ...
                     '90&thinsp;% interval of a measurement', ...
                     'the measurement lies'}, cells)];
end
