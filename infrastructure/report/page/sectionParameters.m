% SECTIONPARAMETERS  Part of the report: parameters and how well they are known.
%
% CALL: [TITLE, HTML] = sectionParameters (PAGE), see writePage and pageData

function [title, html] = sectionParameters (page)
  title = 'Parameters';
  names = page.Case.names;
  c = page.sources.calibration;
  if isempty (c)
    html = boxTable (page);
    return
  end
  figures = [];
  cells = cell (numel (names), 7);
  for j = 1:numel (names)
    [word, text, class] = parameterState (c, names, j);
    figures = [figures, boxFigure(page, j, word)];
    at = @(varargin) pageNumber (page, 'plain', 'calibration', varargin{:});
    label = jsonAt (c, {'labels', names{j}});
    if ischar (label) && ~isempty (label)
      label = ['<br><span class="none">', htmlText(label), '</span>'];
    else
      label = '';
    end
    cells(j, :) = {[htmlText(names{j}), label], at('params', names{j}), ...
                   at('interval90', names{j}, 1), ...
                   at('interval90', names{j}, 2), ...
                   at('limits', names{j}, 1), at('limits', names{j}, 2), ...
                   ['<span class="words"><span class="', class, '">', ...
                    word, '</span>: ', text, '</span>']};
  end
  key = htmlKey ({'area', 'midblue', 'how the sets that fit spread'; ...
                  'xbar', 'blue', 'value and 90 % interval'; ...
                  'box', 'palegrey', 'box (limits of the case)'});
  html = [htmlFigures(figures, key), ...
          htmlTable('Parameters: value, 90&thinsp;% interval, box', ...
                    {'parameter', 'value', 'from', 'to', 'lower limit', ...
                     'upper limit', ...
                     '<span class="words">what is known</span>'}, cells), ...
          looseOnes(c)];
end

function html = boxTable (page)
  html = '';
  if ~isempty (page.sources.gap)
    return                  % the diagnosis has a table of its own
  end
  Case = page.Case;
  cells = cell (numel (Case.names), 3);
  for j = 1:numel (Case.names)
    cells(j, :) = {htmlText(Case.names{j}), ...
                   numberText(Case.limits(1, j)), ...
                   numberText(Case.limits(2, j))};
  end
  html = htmlTable ('The box in which the parameters are looked for', ...
                    {'parameter', 'lower limit', 'upper limit'}, cells);
end

function f = boxFigure (page, j, word)
  c = page.sources.calibration;
  name = page.Case.names{j};
  limits = page.Case.limits(:, j)';
  value = c.params.(name);
  known = c.interval90.(name)(:)';
  alt = sprintf (['%s is %.4g, 90 %% interval %.4g to %.4g, in the box ', ...
                  '%.4g to %.4g: %s'], name, value, known, limits, word);
  f = newFigure ([name, ': ', word], '', '', alt);
  f.size = [340, 96];
  f.xlim = limits + 0.03 * diff (limits) * [-1, 1];
  f.ylim = [-0.25, 1.05];
  f.ynames = {' '};
  f = addLayer (f, 'box', [limits(1), 0.5, limits, -0.25, 1.05], 'palegrey');
  sample = page.posterior(:, j);
  if numel (sample) > 20
    f = addLayer (f, 'area', histogram (sample, limits), 'midblue');
  end
  f = addLayer (f, 'xbar', [value, -0.12, known], 'blue');
  f = addLayer (f, 'diamond', [value, -0.12], 'blue');
end

function table = histogram (sample, limits)
  edges = linspace (limits(1), limits(2), 26)(:);
  counts = histc (sample(:), edges);
  counts(end - 1) = counts(end - 1) + counts(end);
  counts = counts(1:end - 1) / max (counts);
  x = reshape ([edges(1:end - 1), edges(2:end)]', [], 1);
  y = reshape ([counts, counts]', [], 1);
  table = [x, 0 * y, y];
end

function html = looseOnes (c)
  html = '';
  items = cellstr (jsonAt (c, {'unfixed'}));
  items = items(~cellfun (@isempty, items));
  if isempty (items)
    return
  end
  items = cellfun (@(t) ['<li>', htmlText(t), '</li>'], items(:)', ...
                   'UniformOutput', false);
  html = ['<h3>Directions that the targets leave open</h3>', ...
          '<p>Moved together like this, the parameters change no target ', ...
          'beyond its noise:</p><ul>', items{:}, '</ul>'];
end

%!test
%! page = situationPage ('met, one parameter open');
%! [~, html] = sectionParameters (page);
%! text = regexprep (html, '(<[^>]*>|\s)+', ' ');
%! assert (! isempty (strfind (text, 'a 4 3.9 4.1 0 10 fixed : by sum')));
%! assert (! isempty (strfind (text, 'b 3 2.9 3.1 0 10 flat direction')));
