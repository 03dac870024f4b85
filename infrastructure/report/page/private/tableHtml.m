% TABLEHTML  A table as HTML that screen readers can walk.
%
% CALL: HTML = tableHtml (T)
%
%   T     see newTable
%   HTML  '' for a table without rows
%
% A number is a data element with its whole value and where it is from. On a
% narrow screen each row is a block, and each number has the head of its column
% beside it (data-label). Words begin at the left, numbers end at the right.

function html = tableHtml (T)
  html = '';
  if isempty (T) || isempty (T.cells)
    return
  end
  heads = cellfun (@withUnit, htmlText (T.columns(:, 1)), htmlText (T.columns(:, 2)), ...
                   'UniformOutput', false)';
  isWords = strcmp (T.columns(:, 3), 'words')' | ...
            any (cellfun (@(c) ischar (c.value) && ~isempty (c.value), T.cells), 1);
  classes = {'', ' class="text"'};
  classes = classes(1 + isWords);
  lines = cell (1, rows (T.cells));
  for i = 1:rows (T.cells)
    fields = cellfun (@(c, k) cellHtml (c, k), T.cells(i, :), T.columns(:, 3)', ...
                      'UniformOutput', false);
    body = strcat ('<td', classes(2:end), ' data-label="', heads(2:end), '">', ...
                   fields(2:end), '</td>');
    lines{i} = ['<tr><th scope="row">', fields{1}, '</th>', body{:}, "</tr>\n"];
  end
  head = strcat ('<th scope="col"', classes, '>', heads, '</th>');
  notes = strcat ('<p>', htmlText (T.notes), '</p>');
  title = htmlText (T.title);
  html = ['<div class="scroll" role="region" tabindex="0" aria-label="', title, ...
          '"><table><caption><span>', title, '</span></caption><thead><tr>', ...
          head{:}, '</tr></thead><tbody>', lines{:}, "</tbody></table></div>\n", ...
          notes{:}];
end

function html = cellHtml (c, kind)
  if isnumeric (c.value)
    html = strjoin (arrayfun (@(k) dataHtml (c, k, kind), 1:numel (c.value), ...
                              'UniformOutput', false), ' to ');
  else
    html = htmlText (withUnit (c.value, c.unit));
    if strcmp (kind, 'words') && ~isempty (html)
      html = ['<span class="words">', html, '</span>'];
    end
  end
  if isfinite (c.sd)
    sd = struct ('value', c.sd, 'from', c.sdFrom);
    html = [html, ' &plusmn; ', dataHtml(sd, 1, 'error')];
  end
  if ~isempty (c.code) && ~strcmp (c.code, c.value)
    html = [html, ' <span class="none">', htmlText(c.code), '</span>'];
  end
  if ~isempty ([c.class, c.title])
    title = repmat ([' title="', htmlText(c.title), '"'], 1, ~isempty (c.title));
    html = ['<span class="', c.class, '"', title, '>', html, '</span>'];
  end
end

function html = dataHtml (c, k, kind)
  x = c.value(k);
  kind = noiseKind (kind, x, givenField (c, 'sd', NaN));
  html = numberText (x, kind);
  if isnan (x)
    html = ['<span class="none">', html, '</span>'];
  elseif ~isempty (c.from)
    place = repmat (sprintf ('/%d', k), 1, numel (c.value) > 1);
    html = sprintf ('<data value="%.17g" data-kind="%s" data-from="%s">%s</data>', ...
                    x, kind, htmlText ([c.from, place]), html);
  end
end

%!test
%! page.sources.gap = struct ('p', 0.25, 'range', [1; 2]);
%! T = newTable (page, 'x', 'X < Y', {'a', '', ''; 'b', 'N', 'plain'; 'c', '', 'words'}, ...
%!               {struct('value', 'r & s', 'code', 'k'), {'gap', 'p'}, 'w'; ...
%!                'q', {'gap', 'range'}, struct('value', 'v', 'class', 'off')});
%! html = tableHtml (T);
%! for text = {'r &amp; s <span class="none">k</span>', 'aria-label="X &lt; Y"', ...
%!             '<th scope="col">b (N)</th>', 'data-label="b (N)">', ...
%!             'data-from="gap/p">0.25</data>', 'data-from="gap/range/2">2</data>', ...
%!             '<span class="off"><span class="words">v</span></span>'}
%!   assert (! isempty (strfind (html, text{1})), text{1});
%! end
%! assert (tableHtml ([]), '');
%!test
%! % to the noise only
%! page.sources.gap = struct ('x', -4.4e-15, 'sd', 0.0343);
%! T = newTable (page, 'x', 'X', {'a', '', ''; 'b', '', 'plain'; 'c', '', 'change'}, ...
%!               {'r', struct('value', {{'gap', 'x'}}, 'sd', {{'gap', 'sd'}}), ...
%!                struct('value', 0.453, 'sd', 2.1)});
%! html = tableHtml (T);
%! for text = {'data-kind="plain 0" data-from="gap/x">0</data> &plusmn; ', '>0.034</data>', ...
%!             '+0.5 &plusmn; 2.1'}
%!   assert (! isempty (strfind (html, text{1})), html);
%! end

% SPDX-License-Identifier: GPL-3.0-only
