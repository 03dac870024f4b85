% ORIGINOF  Reads what the first lines of a table say of its making.
%
% CALL: [HEAD, REST] = originOf (FILE)
%
%   FILE  path of a table
%   HEAD  struct of texts program, commit, date, machine, hours; '' where nothing
%         is said
%   REST  text, the table below
%
% See also: originLines

function [head, rest] = originOf (file)
  text = fileread (file);
  lead = regexp (text, '^(#[^\n]*\n)*', 'match', 'once');
  rest = text(numel (lead) + 1:end);
  names = {'program', 'commit', 'date', 'machine', 'hours'};
  head = cell2struct (repmat ({''}, 1, 5), names, 2);
  found = regexp (lead, '^# ([\w-]+): ([^\n]*)', 'tokens', 'lineanchors');
  for one = found
    name = strrep (one{1}{1}, 'core-hours', 'hours');
    head.(name) = one{1}{2};
  end
end

%!test
%! file = tempname ();
%! writeAtomic (file, "# program: p a\n# core-hours: 3\na,b\n1,2\n");
%! [head, rest] = originOf (file);
%! assert ({head.program, head.hours, head.commit}, {'p a', '3', ''});
%! assert (rest, "a,b\n1,2\n");

% SPDX-License-Identifier: GPL-3.0-only
