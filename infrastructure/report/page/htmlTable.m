% HTMLTABLE  A table as HTML that screen readers can walk.
%
% CALL: HTML = htmlTable (CAPTION, HEAD, CELLS)
%
%   CAPTION  what the table shows (HTML)
%   HEAD     1 x c cell of column names (HTML)
%   CELLS    n x c cell of HTML; the first column names the row
%
% The table scrolls by itself where the screen is narrow.

function html = htmlTable (caption, head, cells)
  label = regexprep (caption, '<[^>]*>|"', '');
  lines = {['<div class="scroll" role="region" tabindex="0" aria-label="', ...
            label, '"><table><caption><span>', caption, ...
            '</span></caption><thead><tr>']};
  for j = 1:numel (head)
    lines{end + 1} = ['<th scope="col"', classOf(head{j}), '>', head{j}, ...
                      '</th>'];
  end
  lines{end + 1} = '</tr></thead><tbody>';
  for i = 1:rows (cells)
    lines{end + 1} = ['<tr><th scope="row">', cells{i, 1}, '</th>'];
    for j = 2:columns (cells)
      lines{end + 1} = ['<td', classOf(cells{i, j}), '>', cells{i, j}, ...
                        '</td>'];
    end
    lines{end + 1} = "</tr>\n";
  end
  html = [lines{:}, "</tbody></table></div>\n"];
end

% Words begin at the left, numbers end at the right.
function text = classOf (html)
  text = '';
  if ~isempty (strfind (html, 'class="words'))
    text = ' class="text"';
  end
end

%!test
%! html = htmlTable ('what', {'a', 'b'}, {'x', '1'; 'y', '2'});
%! assert (numel (strfind (html, '<th scope="row">')), 2);
%! assert (~isempty (strfind (html, '<td>2</td>')));
%! assert (~isempty (strfind (html, '<span>what</span></caption>')));
