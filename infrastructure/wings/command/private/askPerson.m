% ASKPERSON  Asks at the terminal until there is an answer of use.
%
% CALL: TEXT = askPerson (QUESTION, DEFAULT, RULE)
%       TEXT = askPerson (QUESTION, DEFAULT, RULE, READ)
%
%   QUESTION, DEFAULT  texts; an empty answer takes the default
%   RULE  handle (TEXT) -> [TEXT, FAULT, ECHO], see amountIn; a fault is said, and the
%         question asked again; the echo of what was typed is said. ? says how to answer
%   READ  handle (PROMPT) -> text (default: input)
%
% Errors: DEcalioc:askPerson:missingField (Ctrl-D)

function text = askPerson (question, default, rule, read)
  if nargin < 4
    read = @typed;
  end
  prompt = [question, repmat([' [', default, ']'], 1, ~isempty (default)), ': '];
  while true
    text = strtrim (read (prompt));
    if strcmp (text, '?')
      printf (['  A number may have its unit behind it. Enter takes what stands in brackets, ', ...
               'back returns to the question before, Ctrl-C ends and makes nothing.\n']);
      continue
    end
    isTyped = ~isempty (text);
    if ~isTyped
      text = default;
    end
    [text, fault, echo] = rule (text);
    if isempty (fault)
      break
    end
    printf ('%s\n', fault);
  end
  if isTyped && ~isempty (echo)
    printf ('  taken as %s\n', echo);
  end
end

function text = typed (prompt)
  try
    text = input (prompt, 's');
  catch
    error ('DEcalioc:askPerson:missingField', ...
           '\nan answer is needed, got the end of the input. Nothing was made.');
  end
end

%!function text = nextOf (answers, count)
%!  count('k') = count('k') + 1;
%!  text = answers{count('k')};
%!endfunction
%!test
%! rule = @(text) amountIn (text, 'm');
%! for row = {{'heavy', '4 mm'}, '0.004', '''heavy'''; {''}, '2e-3', ''; ...
%!             {'4', '0.004'}, '0.004', "such as 4 mm.\n  taken as 0.004 m\n"; ...
%!             {'?', '4 mm'}, '0.004', 'Enter takes what stands in brackets'}'
%!   count = containers.Map ({'k'}, {0});
%!   answers = row{1};
%!   read = @(prompt) nextOf (answers, count);
%!   said = evalc ('text = askPerson (''radius'', ''2e-3'', rule, read);');
%!   assert (text, row{2});
%!   assert (isempty (row{3}) || ~isempty (strfind (said, row{3})), said);
%! end

% SPDX-License-Identifier: GPL-3.0-only
