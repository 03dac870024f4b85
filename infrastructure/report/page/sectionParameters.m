% SECTIONPARAMETERS  Parts of the report: parameters and how well they are
% known; which parameter moves which target.
%
% CALL: LIST = sectionParameters (), see writePage
%
% What is known of a parameter, in a word: fixed; dead (no calibrated target has
% a total Sobol index of 0.05 or more for it); trade-off (not fixed, correlation
% above 0.7 with another one); flat direction; at a limit; a compromise (its
% value lies outside its interval); not known (no interval is printed).

function list = sectionParameters ()
  list = {'sectionparameters', 'Values of the parameters', @parameters, {}; ...
          'sectionsensitivity', 'Sensitivity', @sensitivity, ...
          {'sources', 'calibration', 'sensitivity'}};
end

function html = parameters (page)
  names = page.Case.names;
  c = page.sources.calibration;
  if isempty (c)
    html = boxTable (page);
    return
  end
  at = @(varargin) pageNumber (page, 'plain', 'calibration', varargin{:});
  figures = [];
  cells = cell (numel (names), 7);
  for j = 1:numel (names)
    [class, word, text] = parameterState (c, names, j);
    figures = [figures, boxFigure(page, j, word)];
    label = char (jsonAt (c, {'labels', names{j}}));
    if ~isempty (label)
      label = ['<br><span class="none">', htmlText(label), '</span>'];
    end
    cells(j, :) = {[htmlText(names{j}), label], at('params', names{j}), ...
                   at('interval90', names{j}, 1), ...
                   at('interval90', names{j}, 2), ...
                   at('limits', names{j}, 1), at('limits', names{j}, 2), ...
                   ['<span class="words"><span class="', class, '">', ...
                    word, '</span>: ', text, '</span>']};
  end
  key = {'area', 'midblue', 'how the sets that fit spread'; ...
         'xbar', 'blue', 'value and 90 % interval'; ...
         'box', 'palegrey', 'box (limits of the case)'};
  html = [htmlFigures(figures, key), ...
          htmlTable('Parameters: value, 90&thinsp;% interval, box', ...
                    {'parameter', 'value', 'from', 'to', 'lower limit', ...
                     'upper limit', ...
                     '<span class="words">what is known</span>'}, cells), ...
          intervalNote(c), looseOnes(c), toCopy(page, c)];
end

% The lines that go into a model.
function html = toCopy (page, c)
  file = fullfile (page.Case.folder, 'results', 'calibrated.head');
  html = '';
  if ~isfile (file)
    return
  end
  folders = {page.Case.models.folder};
  folders = folders(~cellfun (@isempty, folders));
  lines = unique (cellfun (@(f) propertyLines (f, c.params), folders, ...
                           'UniformOutput', false), 'stable');
  html = ['<details class="open" open><summary>To copy into a model</summary><pre>', ...
          htmlText([fileread(file), lines{:}]), '</pre></details>'];
end

function html = intervalNote (c)
  html = char (jsonAt (c, {'intervalNote'}));
  if ~isempty (html)
    html = ['<p>The intervals are ', htmlText(html), '.</p>'];
  end
end

function html = boxTable (page)
  html = '';
  Case = page.Case;
  if isempty (page.sources.gap)         % the diagnosis has a table of its own
    row = @(j) {htmlText(Case.names{j}), numberText(Case.limits(1, j)), ...
                numberText(Case.limits(2, j))};
    html = htmlTable ('The box in which the parameters are looked for', ...
                      {'parameter', 'lower limit', 'upper limit'}, row, ...
                      numel (Case.names));
  end
end

function f = boxFigure (page, j, word)
  c = page.sources.calibration;
  name = page.Case.names{j};
  box = page.Case.limits(:, j);
  limits = box(1:2)';
  value = c.params.(name);
  known = c.interval90.(name)(:)';
  known(isnan (known)) = value;         % not printed
  alt = sprintf (['%s is %.4g, 90 %% interval %.4g to %.4g, in the box ', ...
                  '%.4g to %.4g: %s'], name, value, known, limits, word);
  f = newFigure ([name, ': ', word], '', '', alt, ...
                 {'box', [limits(1), 0.5, limits, -0.25, 1.05], 'palegrey'; ...
                  'area', histogram(page.posterior(:, j), box), ...
                  'midblue'; ...
                  'xbar', [value, -0.12, known], 'blue'; ...
                  'diamond', [value, -0.12], 'blue'});
  f.size = [340, 96];
  f.xlim = fromUnit ([-0.03; 1.03], box)';
  [f.xlog, f.ylim, f.ynames] = deal (any (box(3:end)), [-0.25, 1.05], {' '});
end

function area = histogram (sample, box)
  area = zeros (0, 3);
  if numel (sample) > 20
    edges = fromUnit (linspace (0, 1, 26)', box);
    counts = histc (sample, edges);
    counts(end - 1) = counts(end - 1) + counts(end);
    counts = counts(1:end - 1) / max (counts);
    x = repelem (edges, 2)(2:end - 1);
    area = [x, 0 * x, repelem(counts, 2)];
  end
end

function html = looseOnes (c)
  html = '';
  items = strcat ('<li>', htmlText (namesIn (c, 'unfixed')), '</li>');
  if ~isempty (items)
    html = ['<h3>Combinations that the tests leave open</h3>', ...
            '<p>Values that fit spread over more than half of what the limits ', ...
            'allow where the parameters move together like this:</p><ul>', ...
            items{:}, '</ul>'];
  end
end

% What fixes parameter J of NAMES, or why nothing does; TEXT is HTML.
function [class, word, text] = parameterState (c, names, j)
  name = names{j};
  value = c.params.(name);
  isLoose = any (strcmp (name, namesIn (c, 'notIdentified')));
  share = sensitivityOf (c, name);
  [partner, link] = partnerOf (c, names, j);
  class = 'unsure';
  if any (strcmp (name, namesIn (c, 'atLimit')))
    sides = {'lower', 'upper'};
    limits = jsonAt (c, {'limits', name});
    isUpper = numel (limits) == 2 && value > mean (limits);
    class = 'off';
    word = 'at a limit';
    text = sprintf ('at its %s limit; the best value may lie beyond', ...
                    sides{1 + isUpper});
  elseif strcmp (jsonAt (c, {'intervalCode'}), 'no fit')
    [word, text] = deal ('not known', 'no interval is printed, see below');
  elseif isLoose && ~isempty (share) && max (share) < 0.05
    word = 'dead';
    text = 'no target responds to it';
  elseif isLoose && ~isempty (partner)
    word = 'trade-off';
    text = ['only together with ', partner, link, ...
            ': more of one is made up for by the other'];
  elseif isLoose
    word = 'flat direction';
    text = 'other values fit as well, together with other parameters';
  elseif isOutside (value, jsonAt (c, {'interval90', name}))
    word = 'a compromise';
    text = ['the value lies outside its interval: it misses least; the ', ...
            'interval is of the likeliest, each target weighed by its noise'];
  else
    class = 'ok';
    word = 'fixed';
    text = ['by ', strongest(c, share)];
    if ~isempty (partner)
      text = [text, '; linked to ', partner, link];
    end
  end
end

function yes = isOutside (value, range)
  yes = isnumeric (range) && numel (range) == 2 && ...
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

function [partner, link] = partnerOf (c, names, j)
  [partner, link] = deal ('');
  R = jsonAt (c, {'correlation'});
  if isequal (size (R), numel (names) * [1, 1])
    r = R(j, :);
    r(j) = 0;
    [most, k] = max (abs (r));
    if most > 0.7
      partner = htmlText (names{k});
      link = [' (correlation ', numberText(r(k)), ')'];
    end
  end
end

function text = strongest (c, share)
  text = 'the targets';
  [~, order] = sort (-share);
  order = order(share(order) >= 0.1);
  if ~isempty (order)
    known = arrayfun (@(t) jsonAt (c, {'targets', t, 'name'}), ...
                      order(1:min (end, 3)), 'UniformOutput', false);
    text = htmlText (strjoin (known, ', '));
  end
end

function html = sensitivity (page)
  html = '';
  names = page.Case.names;
  share = page.sources.calibration.sensitivity;
  if ~all (isfield (share, names))
    return
  end
  shown = shownTargets (page.Case);
  cells = htmlText (names(:));
  for i = 1:numel (shown)
    for j = 1:numel (names)
      html = pageNumber (page, 'probability', 'calibration', 'sensitivity', ...
                         names{j}, shown(i));
      if share.(names{j})(shown(i)) >= 0.3
        html = ['<strong>', html, '</strong>'];
      end
      cells{j, i + 1} = html;
    end
  end
  html = ['<p>Share of the variance of each response over the box that a ', ...
          'parameter makes, alone and with others.</p>', ...
          htmlTable('Share of the variance', ...
                    [{'parameter'}, ...
                     htmlText({page.Case.targets(shown).name})], cells)];
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
%! parameters = sectionParameters (){1, 3};
%! html = parameters (page);
%! found = regexp (html, '<span class="(ok|unsure|off)">([^<]*)<', 'tokens');
%! assert (cellfun (@(f) f{2}, found, 'UniformOutput', false), ...
%!         {'fixed', 'dead', 'trade-off', 'at a limit', 'trade-off', ...
%!          'a compromise'});
%! for text = {'by t1', 'only together with g', 'at its upper limit'}
%!   assert (! isempty (strfind (html, text{1})));
%! end
%! page.sources.calibration.correlation = [];
%! page.sources.calibration.intervalNote = 'not to be used';
%! html = parameters (page);
%! assert (! isempty (strfind (html, 'intervals are not to be used.</p>')));
%! assert (numel (strfind (html, '>flat direction<')), 2);
