% SECTIONWHICH  Part of the report: which effect explains the gap.
%
% CALL: [TITLE, HTML] = sectionWhich (PAGE)
%
%   PAGE  see pageData; TITLE, HTML  see pageSections
%
% See also: pageSections, decideGap

function [title, html] = sectionWhich (page)
  title = 'Which effect is missing';
  html = '';
  which = jsonAt (page.sources.gap, {'which'});
  posterior = jsonAt (which, {'posterior'});
  if ~isstruct (posterior)
    return
  end
  cause = page.verdict.cause;
  html = ['<p><strong>', htmlText(cause.word), '</strong>. ', ...
          htmlText(cause.sentence), ' ', htmlText(cause.closed), '</p>', ...
          htmlFigures(bars (posterior), ''), ...
          effectTable(page, which), remarks(which), ...
          levelRemark(page), expected(page, which)];
end

function html = levelRemark (page)
  html = '';
  level = jsonAt (page.sources.gap, {'level'});
  if isstruct (level)
    html = ['<p>The verdict was ', htmlText(levelText (level)), '</p>'];
  end
end

function f = bars (posterior)
  names = fieldnames (posterior);
  p = cellfun (@(n) posterior.(n), names);
  labels = strrep (strrep (names, 'unlisted', 'none of the listed'), ...
                   'null', 'no gap');
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
  cells = cell (0, 5);
  for k = 1:numel (names)
    name = names{k};
    at = @(kind, varargin) pageNumber (page, kind, 'gap', 'which', ...
                                       varargin{:});
    label = name;
    if strcmp (name, 'null')
      label = 'no gap';
    elseif strcmp (name, 'unlisted')
      label = 'none of the listed';
    end
    own = {'strength', name};
    cells(end + 1, :) = {htmlText(label), ...
                         at('probability', 'posterior', name), ...
                         at('plain', own{:}, 'value'), ...
                         pageInterval(page, 'plain', 'gap', 'which', ...
                                      own{:}, 'interval90'), ...
                         at('plain', own{:}, 'smallestSeen')};
  end
  html = [htmlTable('Causes, the likeliest first', ...
                    {'cause', 'probability', 'strength', ...
                     '90&thinsp;% interval', 'can be seen from'}, cells), ...
          '<p>Strength 0 is off, 1 the limit in <code>loadEffects.m</code>', ...
          '. An effect can take part in several explanations, so the ', ...
          'probabilities need not add up to one.</p>'];
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
