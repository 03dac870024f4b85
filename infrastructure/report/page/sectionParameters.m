% SECTIONPARAMETERS  Part of the report: parameters and how well they are known.
%
% CALL: [TITLE, HTML] = sectionParameters (PAGE), see writePage and pageData
%
% What is known of a parameter, in a word: fixed; dead (no calibrated target has
% a total Sobol index of 0.05 or more for it); trade-off (not fixed, and a
% correlation above 0.7 with another one); flat direction; at a limit; a
% compromise (its value lies outside its interval).

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

% What fixes parameter J of NAMES, or why nothing does; TEXT is HTML.
function [word, text, class] = parameterState (c, names, j)
  name = names{j};
  loose = any (strcmp (name, cellstr (jsonAt (c, {'notIdentified'}))));
  share = sensitivityOf (c, name);
  [partner, r] = partnerOf (c, names, j);
  limits = jsonAt (c, {'limits', name});
  class = 'ok';
  if any (strcmp (name, cellstr (jsonAt (c, {'atLimit'}))))
    side = 'lower';
    if numel (limits) == 2 && c.params.(name) > mean (limits)
      side = 'upper';
    end
    word = 'at a limit';
    text = sprintf ('at its %s limit; the best value may lie beyond', side);
    class = 'off';
  elseif loose && ~isempty (share) && max (share) < 0.05
    word = 'dead';
    text = 'no target responds to it';
    class = 'unsure';
  elseif loose && ~isempty (partner)
    word = 'trade-off';
    text = sprintf (['only together with %s (correlation %s): more of one ', ...
                     'is made up for by the other'], htmlText (partner), ...
                    numberText (r, 'plain'));
    class = 'unsure';
  elseif loose
    word = 'flat direction';
    text = 'other values fit as well, together with other parameters';
    class = 'unsure';
  elseif isOutside (c, name)
    word = 'a compromise';
    text = ['the value lies outside its interval: no set meets all ', ...
            'targets, and this one misses least; the interval is of the ', ...
            'sets that are likeliest, each target weighed by its noise'];
    class = 'unsure';
  else
    word = 'fixed';
    text = ['by ', strongest(c, share)];
    if ~isempty (partner)
      text = sprintf ('%s; linked to %s (correlation %s)', text, ...
                      htmlText (partner), numberText (r, 'plain'));
    end
  end
end

function yes = isOutside (c, name)
  range = jsonAt (c, {'interval90', name});
  value = c.params.(name);
  yes = numel (range) == 2 && isnumeric (range) && ...
        (value < range(1) || value > range(2));
end

% Shares of the variance of the calibrated targets, NaN for the held-out ones.
function share = sensitivityOf (c, name)
  share = jsonAt (c, {'sensitivity', name})(:)';
  for t = 1:numel (share)
    if ~strcmp (jsonAt (c, {'targets', t, 'role'}), 'calibrate')
      share(t) = NaN;
    end
  end
end

function [partner, r] = partnerOf (c, names, j)
  partner = '';
  r = NaN;
  R = jsonAt (c, {'correlation'});
  if ~isequal (size (R), numel (names) * [1, 1])
    return
  end
  row = R(j, :);
  row(j) = 0;
  [most, k] = max (abs (row));
  if most > 0.7
    partner = names{k};
    r = row(k);
  end
end

function text = strongest (c, share)
  text = 'the targets';
  [~, order] = sort (-share);
  order = order(share(order) >= 0.1);
  if ~isempty (order)
    order = order(1:min (end, 3));
    known = arrayfun (@(t) htmlText (jsonAt (c, {'targets', t, 'name'})), ...
                      order, 'UniformOutput', false);
    text = strjoin (known, ', ');
  end
end

%!test
%! % each word
%! page = situationPage ('met');
%! names = {'a', 'b', 'e', 'f', 'g', 'h'};
%! page.Case.names = names;
%! page.Case.limits = repmat ([0; 10], 1, 6);
%! page.posterior = zeros (0, 6);
%! page.sources.calibration = jsondecode (['{"params": {"a": 1, "b": 1, ', ...
%!   '"e": 1, "f": 9.99, "g": 1, "h": 1}, "atLimit": ["f"], ', ...
%!   '"limits": {"f": [0, 10]}, "interval90": {"a": [0, 2], "b": [0, 2], ', ...
%!   '"e": [0, 2], "f": [9, 10], "g": [0, 2], "h": [2, 3]}, ', ...
%!   '"notIdentified": ["b", "e", "g"], "targets": [{"name": "t1", ', ...
%!   '"role": "calibrate"}, {"name": "t2", "role": "holdout"}], ', ...
%!   '"sensitivity": {"a": [0.9, 0], "b": [0.01, 0.9], "e": [0.3, 0], ', ...
%!   '"f": [0.2, 0], "g": [0.2, 0], "h": [0.2, 0]}, "correlation": ', ...
%!   '[[1,0,0,0,0,0], [0,1,0,0,0,0], [0,0,1,0,-0.9,0], [0,0,0,1,0,0], ', ...
%!   '[0,0,-0.9,0,1,0], [0,0,0,0,0,1]]}']);
%! [~, html] = sectionParameters (page);
%! found = regexp (html, '<span class="(ok|unsure|off)">([^<]*)<', 'tokens');
%! assert (cellfun (@(f) f{2}, found, 'UniformOutput', false), ...
%!         {'fixed', 'dead', 'trade-off', 'at a limit', 'trade-off', ...
%!          'a compromise'});
%! for text = {'by t1', 'only together with g', 'at its upper limit'}
%!   assert (! isempty (strfind (html, text{1})));
%! end
%! page.sources.calibration.correlation = [];
%! [~, html] = sectionParameters (page);
%! assert (numel (strfind (html, '>flat direction<')), 2);
%!test
%! page = situationPage ('met, one parameter open');
%! [~, html] = sectionParameters (page);
%! text = regexprep (html, '(<[^>]*>|\s)+', ' ');
%! assert (! isempty (strfind (text, 'a 4 3.9 4.1 0 10 fixed : by sum')));
%! assert (! isempty (strfind (text, 'b 3 2.9 3.1 0 10 flat direction')));
