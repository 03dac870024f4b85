% HTMLTABLE  A table as HTML that screen readers can walk.
%
% CALL: HTML = htmlTable (CAPTION, HEAD, CELLS)
%       HTML = htmlTable (CAPTION, HEAD, ROW, N)
%
%   CAPTION  what the table shows (HTML)
%   HEAD     1 x c cell of column names (HTML)
%   CELLS    n x c cell of HTML; the first column names the row
%   ROW, N   instead: 1 x c cell of row k = ROW (k), and how many there are
%   HTML     '' without rows
%
% The table scrolls by itself where the screen is narrow. Words begin at the
% left, numbers end at the right.

function html = htmlTable (caption, head, cells, n)
  html = '';
  if nargin > 3
    cells = arrayfun (cells, 1:n, 'UniformOutput', false);
    cells = vertcat (cells{:});
  end
  if isempty (cells)
    return
  end
  isWord = ~cellfun (@isempty, strfind ([head; cells], 'class="words'));
  classes = {'', ' class="text"'};
  head = strcat ('<th scope="col"', classes(1 + isWord(1, :)), '>', head, ...
                 '</th>');
  lines = cell (1, rows (cells));
  for i = 1:rows (cells)
    fields = strcat ('<td', classes(1 + isWord(i + 1, 2:end)), '>', ...
                     cells(i, 2:end), '</td>');
    lines{i} = ['<tr><th scope="row">', cells{i, 1}, '</th>', fields{:}, ...
                "</tr>\n"];
  end
  html = ['<div class="scroll" role="region" tabindex="0" aria-label="', ...
          regexprep(caption, '<[^>]*>|"', ''), ...
          '"><table><caption><span>', caption, ...
          '</span></caption><thead><tr>', head{:}, '</tr></thead><tbody>', ...
          lines{:}, "</tbody></table></div>\n"];
end

%!test
%! html = htmlTable ('what', {'a', 'b'}, {'x', '1'; 'y', '2'});
%! assert (numel (strfind (html, '<th scope="row">')), 2);
%! assert (~isempty (strfind (html, '<td>2</td>')));
%! assert (~isempty (strfind (html, '<span>what</span></caption>')));
%! assert (htmlTable ('what', {'a', 'b'}, @(k) {'xy'(k), '12'(k)}, 2), html);
%! assert (htmlTable ('what', {'a'}, {}), '');
