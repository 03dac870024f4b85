% SECTIONCAUSES  Parts of the report: which effect explains the gap; what has
% changed from the reference.
%
% CALL: LIST = sectionCauses (), see writePage

function list = sectionCauses ()
  list = {'sectionwhich', 'What the model lacks', @causes, ...
          {'sources', 'gap', 'which', 'posterior'}; ...
          'sectionchange', 'What has changed', @change, ...
          {'sources', 'gap', 'reference'}};
end

function html = causes (page)
  verdict = page.sources.gap.which;
  posterior = verdict.posterior;
  cause = page.verdict.cause;
  [~, order] = sort (-cellfun (@(n) posterior.(n), fieldnames (posterior)));
  posterior = orderfields (posterior, order);
  html = ['<p><strong>', htmlText(cause.word), '</strong>. ', ...
          htmlText(cause.sentence), ' ', htmlText(cause.closed), ' ', ...
          htmlText(madeByText (jsonAt (verdict, {'cause'}))), '</p>', ...
          shapes(page, posterior), remarks(page, verdict), ...
          '<details><summary>All causes</summary>', ...
          causeTable(page, posterior), '</details>'];
end

% The measured gap beside what each of the likeliest causes would make of it.
function html = shapes (page, posterior)
  html = htmlFigures (bars (page, posterior));
  prints = jsonAt (page.sources.gap, {'fingerprint'});
  names = jsonAt (prints, {'targets'});
  if isempty (names)
    return
  end
  known = setdiff (fieldnames (prints.effects), page.verdict.cause.cannotSee);
  chance = cellfun (@(name) max ([jsonAt(posterior, {name}), 0]), known);
  [~, order] = sort (-chance);
  known = known(order(1:min (3, end)))(:)';
  n = numel (names);
  y = (n:-1:1)';
  measured = prints.measured(:);
  f = newFigure ('The measured gap', 'in sd of the noise', ...
                 cellstr (names), 'The measured gap', ...
                 {'box', [0 * y, y, min(0, measured), max(0, measured), ...
                          y - 0.36, y + 0.36], 'grey'; ...
                  'line', [0, 0.4; 0, n + 0.6], 'ink'});
  f.size = [360, 74 + 22 * n];
  symbols = {'diamond', 'blue'; 'triangle', 'amber'; 'ring', 'red'};
  key = {'box', 'grey', 'measured gap'};
  for k = 1:numel (known)
    f.layers(end + 1, :) = {symbols{k, 1}, ...
                            [prints.effects.(known{k})(:), y], symbols{k, 2}};
    key(end + 1, :) = {symbols{k, :}, htmlText(known{k})};
  end
  why = '';
  if ~isempty (known)
    f.title = 'The gap, and what causes would make of it';
    f.alt = ['The measured gap beside that of ', strjoin(known, ', ')];
    why = ['<p>A cause explains the gap where its symbols stand at the ', ...
           'ends of the bars; two causes look alike where their symbols ', ...
           'lie on each other.</p>'];
  end
  html = [why, htmlFigures([f, bars(page, posterior)], key)];
end

function f = bars (page, posterior)
  p = vertcat (struct2cell (posterior){:});
  p = p(1:min (end, max (6, sum (p >= 0.005))));
  n = numel (p);
  labels = labelsOf (page, posterior)(1:n);
  y = (n:-1:1)';
  f = newFigure ('Probability of each cause', 'probability', labels, ...
                 sprintf ('%s is likeliest, probability %.2f', labels{1}, ...
                          p(1)), ...
                 {'box', [0 * y, y, 0 * y, p, y - 0.32, y + 0.32], 'blue'});
  f.size = [340, 54 + 22 * n];
  f.xlim = [0, 1];
end

function labels = labelsOf (page, posterior)
  labels = fieldnames (posterior)';
  labels(strcmp (labels, 'unlisted')) = {'none of the listed'};
  words = {'no gap', 'nothing has changed'};
  labels(strcmp (labels, 'null')) = words(1 + page.isChange);
end

function html = causeTable (page, posterior)
  names = fieldnames (posterior);
  labels = htmlText (labelsOf (page, posterior));
  row = @(k) {labels{k}, ...
              pageNumber(page, 'probability', 'gap', 'which', 'posterior', ...
                         names{k}), ...
              ['<span class="words">', strengthText(page, names{k}), ...
               '</span>']};
  html = [htmlTable('Causes, the likeliest first', ...
                    {'cause', 'probability', ...
                     ['<span class="words">how strong it would be ', ...
                      '(90&thinsp;% interval)</span>']}, row, ...
                    numel (names)), ...
          '<p>An effect can take part in several explanations, so the ', ...
          'probabilities need not add up to one.</p>'];
end

% In its unit; the share of its range is the tooltip, and all that older files
% have.
function html = strengthText (page, name)
  at = {'which', 'strength', name};
  strength = jsonAt (page.sources.gap, at);
  if isempty (strength)
    html = '';
  elseif any (strcmp (name, page.verdict.cause.cannotSee))
    html = 'cannot be seen';
  elseif isequal (jsonAt (strength, {'says'}), 'nothing')
    html = sentence ('strength.unknown');
  elseif ~isempty (jsonAt (strength, {'text'}))
    html = sprintf ('<span title="%.2g of its range">%s</span>', ...
                    strength.value, htmlText (strength.text));
  else
    html = [pageNumber(page, 'plain', 'gap', at{:}, 'value'), ...
            ' of its range (', ...
            pageNumber(page, 'plain', 'gap', at{:}, 'interval90'), ')'];
  end
end

function html = remarks (page, verdict)
  html = '';
  deciding = namesIn (verdict, 'decides');
  lists = {'Readings without which another cause would be likelier', deciding; ...
           ['<strong>Cannot be seen</strong> with these targets and runs, ', ...
            'so neither found nor excluded'], namesIn(verdict, 'cannotSee'); ...
           'Look-alikes that are not in the list, or have no runs', ...
           namesIn(verdict, 'siblings')};
  for k = 1:numel (jsonAt (verdict, {'groups'}))
    lists(end + 1, :) = {'Taken for each other with these targets', ...
                         jsonAt(verdict, {'groups', k})};
  end
  for one = lists(~cellfun (@isempty, lists(:, 2)), :)'
    html = [html, '<p>', one{1}, ': ', ...
            htmlText(strjoin (one{2}(:)', ', ')), '.</p>'];
  end
  untested = strcat ('<p>', htmlText (page.verdict.cause.untested), '</p>');
  html = [html, untested{:}];
  level = jsonAt (page.sources.gap, {'level'});
  if isstruct (level)
    html = [html, '<p>The verdict was ', htmlText(levelText (level)), '</p>'];
  end
end

function html = change (page)
  reference = page.sources.gap.reference;
  at = @(kind, varargin) pageNumber (page, kind, 'gap', 'reference', ...
                                     varargin{:});
  row = @(t, T) {htmlText([T.model, ': ', T.name]), ...
                 at('plain', 'targets', t, 'reference'), ...
                 at('plain', 'targets', t, 'measured'), ...
                 numberText(T.measured - T.reference, 'change'), ...
                 numberText(T.modelled - T.reference, 'change')};
  html = ['<p>The measurements of <b>', htmlText(reference.condition), ...
          '</b> beside those of the reference. What the model lacks in ', ...
          'both drops out; it is likely to be ', at('percent', 'lack'), ...
          ' of what the parameters move.</p>', beforehand(reference), ...
          htmlTable('Before and after', ...
                    {'target', 'reference', 'now', 'change measured', ...
                     'change modelled'}, ...
                    @(t) row (t, jsonAt (reference, {'targets', t})), ...
                    numel (reference.targets))];
  if numel (reference.conditions) > 1
    html = [html, conditions(reference, at)];
  end
end

% What the user, or the library, took for likely beforehand.
function html = beforehand (reference)
  html = '';
  words = jsonAt (reference, {'canChange'});
  if isempty (words)
    return
  end
  names = fieldnames (words);
  what = {'unlikely', ['Taken as unlikely to have changed, as properties of ', ...
                       'the grains']; ...
          'no', 'Taken as not changed'};
  for one = what'
    own = names(strcmp (struct2cell (words), one{1}));
    if ~isempty (own)
      html = [html, '<p>', one{2}, ': ', htmlText(strjoin (own', ', ')), ...
              '. (<code>canChange</code> in loadEffects.m.)</p>'];
    end
  end
end

function html = conditions (change, at)
  html = htmlTable ('All conditions, each beside the reference', ...
                    {'condition', 'verdict', 'effects'}, ...
                    @(k) conditionRow (jsonAt (change, {'conditions', k})), ...
                    numel (change.conditions));
  for k = 1:numel (change.order)
    one = jsonAt (change.order, {k});
    html = [html, '<p>More ', htmlText(one.effect), ' in ', ...
            htmlText(one.more), ' than in ', htmlText(one.less), ...
            ': probability ', at('probability', 'order', k, 'probability'), ...
            '.</p>'];
  end
end

function cells = conditionRow (one)
  word = one.verdict;
  if strcmp (word, 'no gap')
    word = lower (sentence ('cause.none.word', struct (), true));
  end
  cells = htmlText ({one.name, word, strjoin(namesIn (one, 'effects'), ', ')});
end

%!test
%! % before, after, what was modelled; another condition and the order
%! page.sources.gap.reference = struct ('condition', 'wet', 'lack', 0.1, ...
%!   'targets', struct ('model', 'B', 'name', 'h', 'reference', 1, ...
%!                      'measured', 3, 'modelled', 2.5), ...
%!   'conditions', struct ('name', {'wet', 'dry'}, 'verdict', ...
%!                         {'named', 'no gap'}, 'effects', {{'tilt'}, {}}), ...
%!   'order', struct ('effect', 'tilt', 'more', 'wet', 'less', 'dry', ...
%!                    'probability', 0.9), ...
%!   'canChange', struct ('tilt', 'yes', 'rolling', 'unlikely', 'fill', 'no'));
%! html = sectionCauses (){2, 3} (page);
%! assert (! isempty (strfind (html, '+1.5')));
%! assert (! isempty (strfind (html, 'of the grains: rolling.')));
%! assert (! isempty (strfind (html, 'not changed: fill.')));
%! assert (! isempty (strfind (html, 'nothing has changed')));
%! assert (! isempty (strfind (html, 'More tilt in wet than in dry')));
