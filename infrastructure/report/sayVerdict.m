% SAYVERDICT  Says what a result may be used for, and what to do.
%
% CALL: sayVerdict (V, SAY)
%
%   V    see decideCase
%   SAY  function handle that takes one line of text

function sayVerdict (v, say)
  lines = [strcat({'use it for: '}, v.usableFor), ...
           strcat({'not for: '}, v.notFor), ...
           strcat({v.numbers.label}, {': '}, {v.numbers.text}), ...
           {['what to do: ', v.action]}];
  cellfun (@(line) say (['  ', line]), lines);
end

%!test
%! v = struct ('usableFor', {{'a', 'b'}}, 'notFor', {{'c'}}, 'numbers', ...
%!             struct ('label', 'met', 'text', '2 of 3'), 'action', 'rest');
%! assert (evalc ('sayVerdict (v, @disp)'), ...
%!         ["  use it for: a\n  use it for: b\n  not for: c\n", ...
%!          "  met: 2 of 3\n  what to do: rest\n"]);

% SPDX-License-Identifier: GPL-3.0-only
