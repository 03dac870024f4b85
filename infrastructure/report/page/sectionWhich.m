% SECTIONWHICH  Part of the report: which effect explains the gap.
%
% CALL: [TITLE, HTML] = sectionWhich (PAGE), see writePage and pageData

function [title, html] = sectionWhich (page)
  title = 'What the model lacks';
  html = '';
  which = jsonAt (page.sources.gap, {'which'});
  posterior = jsonAt (which, {'posterior'});
  if ~isstruct (posterior)
    return
  end
  cause = page.verdict.cause;
  html = ['<p><strong>', htmlText(cause.word), '</strong>. ', ...
          htmlText(cause.sentence), ' ', htmlText(cause.closed), '</p>', ...
          shapes(page, which), ...
          remarks(which), levelRemark(page), ...
          '<details><summary>All causes, and how often such a verdict is ', ...
          'right</summary>', effectTable(page, which), ...
          expected(page, which), '</details>'];
end

% The measured gap beside what each of the likeliest causes would make of it.
function html = shapes (page, which)
  html = htmlFigures (bars (which.posterior, nullLabel (page)), '');
  own = jsonAt (page.sources.gap, {'fingerprint'});
  names = jsonAt (own, {'targets'});
  if isempty (names)
    return
  end
  causes = setdiff (fieldnames (own.effects), namesIn (which, 'cannotSee'));
  [~, order] = sort (-causeChances (which, causes));
  causes = causes(order(1:min (3, end)))(:)';
  n = numel (names);
  y = (n:-1:1)';
  f = newFigure ('The measured gap', 'in sd of the noise', ...
                 '', 'The measured gap');
  f.size = [360, 74 + 22 * n];
  f.ynames = flipud (cellstr (names)(:))';
  f.ylim = [0.4, n + 0.6];
  measured = own.measured(:);
  f = addLayer (f, 'box', [0 * y, y, min(0, measured), max(0, measured), ...
                           y - 0.36, y + 0.36], 'grey');
  f = addLayer (f, 'line', [0, 0.4; 0, n + 0.6], 'ink');
  kinds = {'diamond', 'triangle', 'ring'};
  colours = {'blue', 'amber', 'red'};
  key = {'box', 'grey', 'measured gap'};
  for k = 1:numel (causes)
    f = addLayer (f, kinds{k}, [own.effects.(causes{k})(:), y], colours{k});
    key(end + 1, :) = {kinds{k}, colours{k}, htmlText(causes{k})};
  end
  why = '';
  if ~isempty (causes)
    f.title = 'The gap, and what causes would make of it';
    f.alt = ['The measured gap beside that of ', strjoin(causes, ', ')];
    why = ['<p>A cause explains the gap where its symbols stand at the ', ...
           'ends of the bars; two causes look alike where their symbols ', ...
           'lie on each other.</p>'];
  end
  html = [why, htmlKey(key), ...
          htmlFigures([f, bars(which.posterior, nullLabel (page))], '')];
end

function p = causeChances (which, names)
  p = zeros (numel (names), 1);
  for k = 1:numel (names)
    p(k) = max ([jsonAt(which, {'posterior', names{k}}), 0]);
  end
end

function html = levelRemark (page)
  html = '';
  level = jsonAt (page.sources.gap, {'level'});
  if isstruct (level)
    html = ['<p>The verdict was ', htmlText(levelText (level)), '</p>'];
  end
end

function label = nullLabel (page)
  label = 'no gap';
  if ~isempty (jsonAt (page.sources.gap, {'reference'}))
    label = 'nothing has changed';
  end
end

function f = bars (posterior, word)
  names = fieldnames (posterior);
  p = cellfun (@(n) posterior.(n), names);
  labels = strrep (strrep (names, 'unlisted', 'none of the listed'), ...
                   'null', word);
  [p, order] = sort (p, 'descend');
  labels = labels(order);
  shown = 1:min (numel (p), max (6, sum (p >= 0.005)));
  p = p(shown);
  labels = labels(shown);
  n = numel (p);
  y = (n:-1:1)';
  f = newFigure ('Probability of each cause', 'probability', '', ...
                 sprintf ('%s is likeliest, probability %.2f', labels{1}, ...
                          p(1)));
  f.size = [340, 54 + 22 * n];
  f.xlim = [0, 1];
  f.ylim = [0.4, n + 0.6];
  f.ynames = fliplr (labels(:)');
  f = addLayer (f, 'box', [0 * y, y, 0 * y, p, y - 0.32, y + 0.32], 'blue');
end

function html = effectTable (page, which)
  names = fieldnames (which.posterior);
  p = cellfun (@(n) which.posterior.(n), names);
  [~, order] = sort (-p);
  names = names(order);
  cells = cell (0, 3);
  for k = 1:numel (names)
    name = names{k};
    label = name;
    if strcmp (name, 'null')
      label = nullLabel (page);
    elseif strcmp (name, 'unlisted')
      label = 'none of the listed';
    end
    cells(end + 1, :) = {htmlText(label), ...
                         pageNumber(page, 'probability', 'gap', 'which', ...
                                    'posterior', name), ...
                         ['<span class="words">', strengthText(page, name), ...
                          '</span>']};
  end
  html = [htmlTable('Causes, the likeliest first', ...
                    {'cause', 'probability', ...
                     ['<span class="words">how strong it would be ', ...
                      '(90&thinsp;% interval)</span>']}, cells), ...
          '<p>An effect can take part in several explanations, so the ', ...
          'probabilities need not add up to one.</p>'];
end

% In its unit; the share of its range is the tooltip, and all that older files
% have.
function html = strengthText (page, name)
  own = jsonAt (page.sources.gap, {'which', 'strength', name});
  html = '';
  if isempty (own)
    return
  end
  if any (strcmp (name, page.verdict.cause.cannotSee))
    html = 'cannot be seen';
    return
  end
  at = {'gap', 'which', 'strength', name};
  html = [pageNumber(page, 'plain', at{:}, 'value'), ' of its range (', ...
          pageNumber(page, 'plain', at{:}, 'interval90'), ')'];
  if isfield (own, 'text') && ~isempty (own.text)
    html = sprintf ('<span title="%.2g of its range">%s</span>', own.value, ...
                    htmlText (own.text));
  end
end

function html = remarks (which)
  html = '';
  blind = jsonAt (which, {'cannotSee'});
  if ~isempty (blind)
    html = ['<p><strong>Cannot be seen</strong> with these targets and ', ...
            'runs, so neither found nor excluded: ', ...
            htmlText(strjoin (cellstr (blind)(:)', ', ')), '.</p>'];
  end
  siblings = jsonAt (which, {'siblings'});
  if ~isempty (siblings)
    html = [html, '<p>Look-alikes that are not in the list, or have no ', ...
            'runs: ', htmlText(strjoin (cellstr (siblings)(:)', ', ')), ...
            '.</p>'];
  end
  groups = jsonAt (which, {'groups'});
  for k = 1:numel (groups)
    members = jsonAt (groups, {k});
    if iscellstr (members)
      html = [html, '<p>Taken for each other with these targets: ', ...
              htmlText(strjoin (members(:)', ', ')), '.</p>'];
    end
  end
end

function html = expected (page, which)
  html = '';
  if isempty (jsonAt (which, {'expected', 'n'}))
    return
  end
  rows_ = {'top1', 'the likeliest effect is the true one'; ...
           'precision', 'a name that is given is right'; ...
           'falseName', 'a name is given although there is no gap'; ...
           'wrongUnlisted', ...
           'a name is given although the cause is not on the list'};
  cells = cell (0, 2);
  for k = 1:rows (rows_)
    if isempty (jsonAt (which, {'expected', rows_{k, 1}}))
      continue                          % not one of the data sets was so
    end
    cells(end + 1, :) = {rows_{k, 2}, ...
                         pageNumber(page, 'percent', 'gap', 'which', ...
                                    'expected', rows_{k, 1})};
  end
  html = ['<h3>How often such a verdict is right</h3><p>On ', ...
          pageNumber(page, 'count', 'gap', 'which', 'expected', 'n'), ...
          ' data sets with a known cause, drawn for these very targets ', ...
          'and runs and diagnosed the same way:</p>', ...
          htmlTable('Hit rates to expect', {'how often', 'share'}, cells)];
end

%!test
%! page = situationPage ('missed, several');
%! [~, html] = sectionWhich (page);
%! text = regexprep (html, '(<[^>]*>|\s)+', ' ');
%! assert (! isempty (strfind (text, 'One of these: cohesion, drag')));
%! assert (! isempty (strfind (text, '0.90 cohesion 41 kJ/m3 (31 to 58)')));
