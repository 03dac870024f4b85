% SECTIONCHANGE  Part of the report: before and after, beside each other.
%
% CALL: [TITLE, HTML] = sectionChange (PAGE), see writePage and pageData

function [title, html] = sectionChange (page)
  title = 'What has changed';
  html = '';
  change = jsonAt (page.sources.gap, {'reference'});
  if isempty (change)
    return
  end
  html = ['<p>The measurements of <b>', htmlText(change.condition), ...
          '</b> beside those of the reference. What the model lacks in ', ...
          'both drops out; it is likely to be ', ...
          pageNumber(page, 'percent', 'gap', 'reference', 'lack'), ...
          ' of what the parameters move.</p>', targetTable(page, change), ...
          conditionTable(page, change)];
end

function html = targetTable (page, change)
  n = numel (change.targets);
  cells = cell (n, 5);
  for t = 1:n
    own = jsonAt (change.targets, {t});
    at = @(field) pageNumber (page, 'plain', 'gap', 'reference', 'targets', ...
                              t, field);
    cells(t, :) = {[htmlText(own.model), ': ', htmlText(own.name)], ...
                   at('reference'), at('measured'), ...
                   signed(own.measured - own.reference), ...
                   signed(own.modelled - own.reference)};
  end
  html = htmlTable ('Before and after', ...
                    {'target', 'reference', 'now', 'change measured', ...
                     'change modelled'}, cells);
end

function text = signed (value)
  text = '&ndash;';
  if isscalar (value) && isfinite (value)
    text = strrep (sprintf ('%+.3g', value), '-', '&minus;');
  end
end

function html = conditionTable (page, change)
  n = numel (change.conditions);
  html = '';
  if n < 2
    return
  end
  cells = cell (n, 3);
  for k = 1:n
    own = jsonAt (change.conditions, {k});
    word = own.verdict;
    if strcmp (word, 'no gap')
      word = 'nothing has changed';
    end
    effects = cellstr (own.effects);
    cells(k, :) = {htmlText(own.name), htmlText(word), ...
                   htmlText(strjoin (effects(:)', ', '))};
  end
  html = htmlTable ('All conditions, each beside the reference', ...
                    {'condition', 'verdict', 'effects'}, cells);
  for k = 1:numel (change.order)
    own = jsonAt (change.order, {k});
    html = [html, '<p>More ', htmlText(own.effect), ' in ', ...
            htmlText(own.more), ' than in ', htmlText(own.less), ...
            ': probability ', ...
            pageNumber(page, 'probability', 'gap', 'reference', 'order', k, ...
                       'probability'), '.</p>'];
  end
end

%!test
%! % before, after, what was modelled; another condition and the order
%! page.sources.gap.reference = struct ('condition', 'wet', 'lack', 0.1, ...
%!   'targets', struct ('model', 'B', 'name', 'h', 'reference', 1, ...
%!                      'measured', 3, 'modelled', 2.5), ...
%!   'conditions', struct ('name', {'wet', 'dry'}, 'verdict', ...
%!                         {'named', 'no gap'}, 'effects', {{'tilt'}, {}}), ...
%!   'order', struct ('effect', 'tilt', 'more', 'wet', 'less', 'dry', ...
%!                    'probability', 0.9));
%! [~, html] = sectionChange (page);
%! assert (! isempty (strfind (html, '+1.5')));
%! assert (! isempty (strfind (html, 'nothing has changed')));
%! assert (! isempty (strfind (html, 'More tilt in wet than in dry')));
%! page.sources.gap = [];
%! [~, html] = sectionChange (page);
%! assert (html, '');
