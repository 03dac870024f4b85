% MARKDOWNTABLE  A table in Markdown.
%
% CALL: TEXT = markdownTable (TITLES, ROWS)
%
%   TITLES  1 x m cell of text;  ROWS  n x m cell of text
%   TEXT    char, ends with a line feed

function text = markdownTable (titles, rows_)
  lines = [{titles}; mat2cell(rows_, ones (rows (rows_), 1), columns (rows_))];
  lines = cellfun (@(c) ['| ', strjoin(c, ' | '), ' |'], lines, ...
                   'UniformOutput', false);
  rule = ['|', repmat('---|', 1, numel (titles))];
  text = [strjoin([lines(1); {rule}; lines(2:end)]', "\n"), "\n"];
end

%!assert (markdownTable ({'a', 'b'}, {'1', '2'; '', 'x'}), ...
%!        "| a | b |\n|---|---|\n| 1 | 2 |\n|  | x |\n")
