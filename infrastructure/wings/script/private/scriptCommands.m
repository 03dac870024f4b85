% SCRIPTCOMMANDS  The commands of a LIGGGHTS script, cut into words.
%
% CALL: COMMANDS = scriptCommands (TEXT)
%
%   TEXT      of a script
%   COMMANDS  1 x n struct array in the order of TEXT: words (1 x w cell,
%             quotes taken off), isSure (logical: false for those that an if
%             may carry out, which stand behind it)
%
% Lines that end in & go on; what is behind # outside of quotes is a remark.

function commands = scriptCommands (text)
  text = regexprep (strrep (text, "\r", ''), '&[ \t]*\n', ' ');
  commands = struct ('words', cell (1, 0), 'isSure', true);
  for line = strsplit (text, "\n")
    words = wordsOf (line{1});
    if isempty (words)
      continue
    end
    commands(end + 1) = struct ('words', {words}, 'isSure', true);
    inside = cellfun (@wordsOf, ifWords (words), 'UniformOutput', false);
    for part = inside(~cellfun (@isempty, inside))
      commands(end + 1) = struct ('words', part, 'isSure', false);
    end
  end
end

function words = wordsOf (line)
  form = '"[^"]*"(?=\s|$)|''[^'']*''(?=\s|$)|#.*|[^\s#]+';
  words = regexp (line, form, 'match');
  words = words(~strncmp (words, '#', 1));
  words = regexprep (words, '^(["''])(.*)\1$', '$2');
end

% if CONDITION then COMMAND... [elif CONDITION COMMAND...] [else COMMAND...]
function list = ifWords (words)
  list = cell (1, 0);
  if ~strcmp (words{1}, 'if') || numel (words) < 4
    return
  end
  words = words(4:end);
  isElif = [false, strcmp(words(1:end - 1), 'elif')];
  list = words(~isElif & ~ismember (words, {'elif', 'else'}));
end

%!test
%! text = ["a 'b c' # d\n\n# e\nfix x &\n  all y\r\nif \"${m} > 9\" then ", ...
%!         "\"jump 'in 2'\" quit elif \"1 > 2\" 'print \"f\"' else \"log g\"\n", ...
%!         "print \"no # remark\" \"two\"three\n"];
%! c = scriptCommands (text);
%! assert (c(1).words, {'a', 'b c'});
%! assert (c(2).words, {'fix', 'x', 'all', 'y'});
%! assert ({c(4:7).words}, {{'jump', 'in 2'}, {'quit'}, {'print', 'f'}, ...
%!                          {'log', 'g'}});
%! assert ([c.isSure], logical ([1, 1, 1, 0, 0, 0, 0, 1]));
%! assert (c(8).words{2}, 'no # remark');
%!assert (size (scriptCommands ('')), [1, 0])

% SPDX-License-Identifier: GPL-3.0-only
