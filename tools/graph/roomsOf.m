% ROOMSOF  The room in which each place lies.
%
% CALL: rooms = roomsOf (places)
%
% places  n x 1 cellstr, see folderCalls
% rooms   n x 1 cellstr: the first folder of each place; of a wing the second
%         one, too ('wings/script')
%
% See also: folderCalls

function rooms = roomsOf (places)
  rooms = regexprep (places, '^((?:wings/)?[^/]*).*$', '$1');
end

%!assert (roomsOf ({'main'; 'runs/table'; 'wings/script'; 'wings/page/html'}), ...
%!        {'main'; 'runs'; 'wings/script'; 'wings/page'})

% SPDX-License-Identifier: GPL-3.0-only
