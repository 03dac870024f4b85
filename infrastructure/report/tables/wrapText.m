% WRAPTEXT  A text in lines that are no longer than there is room.
%
% CALL: LINES = wrapText (TEXT, WIDTH)
%
%   TEXT   row of char
%   WIDTH  most characters of a line; a longer word has a line of its own
%   LINES  1 x n cell, at least one

function lines = wrapText (text, width)
  lines = {''};
  for word = strsplit (text, ' ')
    if isempty (lines{end}) && numel (lines) == 1
      lines{end} = word{1};
    elseif numel (lines{end}) + 1 + numel (word{1}) <= width
      lines{end} = [lines{end}, ' ', word{1}];
    else
      lines{end + 1} = word{1};
    end
  end
end

%!assert (wrapText ('a bc def', 4), {'a bc', 'def'})
%!assert (wrapText ('abcdef g', 4), {'abcdef', 'g'})
%!assert (wrapText ('', 4), {''})

% SPDX-License-Identifier: GPL-3.0-only
