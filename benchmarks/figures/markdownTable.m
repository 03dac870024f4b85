% MARKDOWNTABLE  A table in Markdown.
%
% CALL: TEXT = markdownTable (TITLES, CELLS)
%
%   TITLES  1 x m cell of text;  CELLS  n x m cell of text
%   TEXT    char, ends with a line feed

function text = markdownTable (titles, cells)
  lines = [{titles}; mat2cell(cells, ones (rows (cells), 1), columns (cells))];
  lines = cellfun (@(c) ['| ', strjoin(c, ' | '), ' |'], lines, ...
                   'UniformOutput', false);
  rule = ['|', repmat('---|', 1, numel (titles))];
  text = [strjoin([lines(1); {rule}; lines(2:end)]', "\n"), "\n"];
end

%!assert (markdownTable ({'a', 'b'}, {'1', '2'; '', 'x'}), ...
%!        "| a | b |\n|---|---|\n| 1 | 2 |\n|  | x |\n")

% SPDX-License-Identifier: GPL-3.0-only
