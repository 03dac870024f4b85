% SECTIONHOWFAR  Part of the report: how far the gap shrinks with the effect.
%
% CALL: [TITLE, HTML] = sectionHowFar (PAGE), see writePage and pageData

function [title, html] = sectionHowFar (page)
  title = 'How far the gap shrinks';
  html = '';
  cure = jsonAt (page.sources.gap, {'howFar'});
  if isempty (jsonAt (cure, {'before'})) || ~isfinite (cure.before)
    return
  end
  how = 'on the surrogates, not yet by DEM runs';
  if isequal (jsonAt (cure, {'verifiedByDEM'}), true)
    how = 'by DEM runs';
  end
  effect = jsonAt (cure, {'effect'});
  if ~ischar (effect) || isempty (effect)
    effect = 'the effect that was found';
  end
  key = htmlKey ({'box', 'grey', 'without the effect'; ...
                  'box', 'blue', 'with it'; ...
                  'dash', 'ink', 'what noise alone makes (floor)'; ...
                  'xbar', 'blue', 'gap closed by the effect, 90 % interval'; ...
                  'ring', 'ink', 'gap closed by a placebo'; ...
                  'dash', 'green', 'the whole gap'});
  html = ['<p>The model was fitted again with ', htmlText(effect), ...
          ', and compared ', how, '. Held-out targets were never ', ...
          'fitted.</p>', ...
          htmlFigures([deviations(cure), closures(cure, effect, false), ...
                       closures(cure, effect, true)], key), ...
          closureTable(page, cure), ...
          paramTable(page, cure)];
end

function f = deviations (cure)
  sets = {cure};
  names = {'calibrated'};
  held = jsonAt (cure, {'heldOut'});
  if isstruct (held)
    sets{end + 1} = held;
    names{end + 1} = 'held out';
  end
  n = numel (sets);
  alt = sprintf (['deviation before %.3g %% and after %.3g %% of the range', ...
                  ', floor %.3g %%'], 100 * cure.before, 100 * cure.after, ...
                 100 * cure.floor);
  f = newFigure ('Deviation of the targets', ...
                 'rms deviation (% of the range)', '', alt);
  f.size = [340, 80 + 46 * n];
  f.ylim = [0.4, n + 0.6];
  f.ynames = fliplr (names);
  most = 0;
  for k = 1:n
    y = n + 1 - k;
    s = sets{k};
    both = 100 * [s.before, s.after];
    f = addLayer (f, 'box', [0, y, 0, both(1), y + 0.03, y + 0.36], 'grey');
    f = addLayer (f, 'box', [0, y, 0, both(2), y - 0.36, y - 0.03], 'blue');
    f = addLayer (f, 'dash', 100 * s.floor * [1, 0; 1, 0] + ...
                  [0, y - 0.42; 0, y + 0.42], 'ink');
    most = max ([most, both, 100 * s.floor]);
  end
  f.xlim = [0, 1.05 * most];
end

% Share of the gap that the effect and each placebo close; on the held-out
% targets or on the calibrated ones.
function f = closures (cure, effect, isHeld)
  f = [];
  title = 'Gap closed, calibrated targets';
  own = cure;
  field = 'closure';
  if isHeld
    title = 'Gap closed, held-out targets';
    own = jsonAt (cure, {'heldOut'});
    field = 'heldOut';
  end
  known = jsonAt (own, {'closure'});
  if isempty (known) || ~isfinite (known)
    return
  end
  names = {effect};
  x = 100 * known;
  placebos = jsonAt (cure, {'placebos'});
  for k = 1:numel (placebos)
    names{end + 1} = ['placebo ', jsonAt(placebos, {k, 'effect'})];
    share = [jsonAt(placebos, {k, field}), NaN];
    x(end + 1) = 100 * share(1);
  end
  n = numel (names);
  y = (n:-1:1)';
  alt = sprintf ('%s: %s closes %.3g %%', title, effect, x(1));
  f = newFigure (title, 'gap closed (%)', '', alt);
  f.size = [340, 66 + 26 * n];
  f.ylim = [0.4, n + 0.6];
  f.ynames = fliplr (names);
  f = addLayer (f, 'dash', [100, 0.4; 100, n + 0.6], 'green');
  f = addLayer (f, 'line', [0, 0.4; 0, n + 0.6], 'grey');
  f = addLayer (f, 'ring', [x(2:end)', y(2:end)], 'ink');
  f = addLayer (f, 'xbar', [x(1), n, 100 * own.interval90(:)'], 'blue');
end

function html = closureTable (page, cure)
  cells = closureRow (page, 'calibrated targets', 'howFar');
  if isstruct (jsonAt (cure, {'heldOut'}))
    cells(2, :) = closureRow (page, 'held-out targets', 'howFar', 'heldOut');
  end
  placebos = jsonAt (cure, {'placebos'});
  for k = 1:numel (placebos)
    name = ['placebo ', htmlText(jsonAt (placebos, {k, 'effect'}))];
    if isequal (jsonAt (cure, {'verifiedByDEM'}), true) && ...
       isequal (jsonAt (placebos, {k, 'verifiedByDEM'}), false)
      name = [name, ' (on the surrogates)'];
    end
    at = @(field) pageNumber (page, 'percent', 'gap', 'howFar', ...
                              'placebos', k, field);
    cells(end + 1, :) = {[name, ', calibrated'], '', '', '', ...
                         at('closure'), ''};
    cells(end + 1, :) = {[name, ', held out'], '', '', '', at('heldOut'), ''};
  end
  html = [htmlTable('How much of the gap is closed', ...
                    {'targets', 'before', 'after', 'floor', 'gap closed', ...
                     '90&thinsp;% interval'}, cells), ...
          '<p>A placebo is another effect, fitted with the same freedom. ', ...
          'The found effect is believable where it closes clearly more ', ...
          'than the placebos do, above all on held-out targets. More ', ...
          'than 100&thinsp;%: less is left than noise makes.</p>'];
end

function cells = closureRow (page, name, varargin)
  at = @(kind, varargin) pageNumber (page, kind, 'gap', varargin{:});
  cells = {name, at('percent', varargin{:}, 'before'), ...
           at('percent', varargin{:}, 'after'), ...
           at('percent', varargin{:}, 'floor'), ...
           at('percent', varargin{:}, 'closure'), ...
           pageNumber(page, 'percent', 'gap', varargin{:}, 'interval90')};
end

function html = paramTable (page, cure)
  html = '';
  params = jsonAt (cure, {'params'});
  if ~isstruct (params)
    return
  end
  names = fieldnames (params);
  cells = cell (numel (names), 3);
  for j = 1:numel (names)
    at = @(k) pageNumber (page, 'plain', 'gap', 'howFar', 'params', ...
                          names{j}, k);
    cells(j, :) = {htmlText(names{j}), at(1), at(2)};
  end
  html = htmlTable ('Parameters fitted without and with the effect', ...
                    {'parameter', 'without', 'with'}, cells);
  if ~isempty (page.sources.calibration)
    html = [html, '<p>', whyTwoSets(), '</p>'];
  end
end

%!test
%! page = situationPage ('missed, named');
%! [~, html] = sectionHowFar (page);
%! text = regexprep (html, '(<[^>]*>|\s)+', ' ');
%! assert (! isempty (strfind (text, 'compared on the surrogates, not yet')));
%! assert (! isempty (strfind (text, 'targets 23.1&thinsp;% 4.2&thinsp;%')));
%! assert (! isempty (strfind (text, 'placebo tilt, held out 10&thinsp;%')));
