% SECTIONTARGETS  Part of the report: the targets and how they are met.
%
% CALL: [TITLE, HTML] = sectionTargets (PAGE), see writePage and pageData

function [title, html] = sectionTargets (page)
  title = 'Targets';
  if isempty (page.sources.calibration)
    html = askedFor (page);
    return
  end
  [figures, key] = deal ([], '');
  for name = {page.Case.models.name}
    if ~strcmp (name{1}, page.verdict.worst)      % that one stands on top
      [f, key] = benchFigure (page, name{1});
      figures = [figures, f];
    end
  end
  html = [htmlFigures(figures, key), curveParts(page), ...
          resultTable(page), predictions(page)];
end

function html = curveParts (page)
  html = '';
  curves = curveSummary (page.Case, zeros (1, numel (page.Case.targets)));
  figures = [];
  for c = curves
    figures = [figures, targetCurve(page, c.own)];
  end
  if ~isempty (figures)
    html = htmlFigures (figures, ...
                        htmlKey ({'area', 'palegreen', 'allowed'; ...
                                  'dots', 'ink', 'measured'; ...
                                  'line', 'blue', 'simulated'; ...
                                  'area', 'midblue', 'its 90 % interval'}));
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
    if T.isAbsolute
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

% One row a target; a curve is one, as decideCase has it.
function html = resultTable (page)
  misses = page.verdict.misses;
  cells = cell (0, 7);
  for m = misses(~strcmp ({misses.role}, 'unmeasured'))
    t = find (strcmp ({page.Case.targets.name}, m.name) & ...
              strcmp ({page.Case.targets.modelName}, m.model), 1);
    if isempty (t)
      cells(end + 1, :) = curveRow (m);
      continue
    end
    at = @(field) pageNumber (page, 'plain', 'calibration', 'targets', t, ...
                              field);
    reach = arrayfun (@(x) numberText (x), page.reach(t, :), ...
                      'UniformOutput', false);
    simulated = at ('estimate');
    if isempty (jsonAt (page.sources.calibration, {'targets', t, 'estimate'}))
      simulated = at ('result');
    end
    cells(end + 1, :) = {[nameOf(page, t), ' <span class="none">', ...
                          htmlText(m.model), '</span>'], metWord(m), ...
                         at('target'), simulated, ...
                         numberText(m.allowed), afterOf(page, m), ...
                         strjoin(reach, ' to ')};
  end
  why = ['<p>With the effect: ', lower(whyTwoSets ()(1)), ...
         whyTwoSets()(2:end), '</p>'];
  head = {'target', '<span class="words short">met?</span>', 'measured', ...
          'simulated', 'allowed &plusmn;', 'with the effect', ...
          'the box reaches'};
  if ~page.showsEffect || ...
     isempty (jsonAt (page.sources.gap, {'howFar', 'targets'}))
    head(6) = [];
    cells(:, 6) = [];
    why = '';
  end
  html = htmlTable (['Measured and simulated, the largest miss first; ', ...
                     'allowed of a held-out target: where a measurement ', ...
                     'lies in 90&thinsp;% of cases'], ...
                    head, cells);
  html = [html, why];
end

function cells = curveRow (m)
  share = numberText (m.share);
  cells = {[htmlText(m.name), ' <span class="none">', htmlText(m.model), ...
            ', curve</span>'], metWord(m), '', '', '', '', ...
           sprintf('%s times what is allowed', share)};
end

function word = metWord (m)
  words = {'missed', 'met'};
  classes = {'off', 'ok'};
  if strcmp (m.role, 'holdout')
    words = {'missed', 'predicted'};
  end
  word = '<span class="words short">not measured</span>';
  if isfinite (m.met)
    word = sprintf ('<span class="words short %s">%s</span>', ...
                    classes{m.met + 1}, words{m.met + 1});
  end
end

function html = afterOf (page, m)
  html = '<span class="none">&ndash;</span>';
  list = jsonAt (page.sources.gap, {'howFar', 'targets'});
  for k = 1:numel (list)
    own = jsonAt (list, {k});
    if strcmp (own.name, m.name) && strcmp (own.model, m.model)
      html = pageNumber (page, 'plain', 'gap', 'howFar', 'targets', k, ...
                         'after');
    end
  end
end

% What nobody has measured yet.
function html = predictions (page)
  held = jsonAt (page.sources.calibration, {'holdout'});
  cells = cell (0, 3);
  for k = 1:numel (held)
    if isempty (jsonAt (held, {k, 'inside'}))
      cells(end + 1, :) = {htmlText(jsonAt (held, {k, 'name'})), ...
                           pageNumber(page, 'plain', 'calibration', ...
                                      'holdout', k, 'result'), ...
                           pageNumber(page, 'plain', 'calibration', ...
                                      'holdout', k, 'interval90')};
    end
  end
  html = '';
  if ~isempty (cells)
    html = htmlTable ('Not measured yet: what the set predicts', ...
                      {'target', 'predicted', ...
                       '90&thinsp;% interval of a measurement'}, cells);
  end
end

% A measured curve and what the found set gives; OWN  numbers of its points.
function f = targetCurve (page, own)
  T = page.Case.targets(own);
  [at, order] = sort ([T.at]);
  own = own(order);
  T = T(order);
  read = @(field) arrayfun (@(t) jsonAt (page.sources.calibration, ...
                                         {'targets', t, field}), own)';
  result = read ('result');
  half = arrayfun (@halfWidth, T)';
  value = [T.value]';
  alt = sprintf ('%s: measured and found at %d points, from %.4g and %.4g', ...
                 T(1).series, numel (own), value(1), result(1));
  alt = sprintf ('%s to %.4g and %.4g', alt, value(end), result(end));
  f = newFigure (sprintf ('%s: %s', T(1).modelName, T(1).series), ...
                 'where it was measured', page.units{own(1)}, alt);
  at = at(:);
  f = addLayer (f, 'area', [at, value - half, value + half], 'palegreen');
  if isfield (jsonAt (page.sources.calibration, {'targets', own(1)}), ...
              'interval90')
    inner = arrayfun (@(t) jsonAt (page.sources.calibration, ...
                                   {'targets', t, 'interval90'})(:)', own, ...
                      'UniformOutput', false);
    f = addLayer (f, 'area', [at, vertcat(inner{:})], 'midblue');
  end
  f = addLayer (f, 'line', [at, result], 'blue');
  f = addLayer (f, 'dots', [at, value], 'ink');
end

%!test
%! page = situationPage ('met, held out outside');
%! [~, html] = sectionTargets (page);
%! text = regexprep (html, '(<[^>]*>|\s)+', ' ');
%! assert (! isempty (strfind (text, 'sum First met 7 7 0.14')));
%! assert (! isempty (strfind (text, 'difference Second missed 5 1 0.2')));
%! assert (isempty (strfind (text, 'with the effect')));
