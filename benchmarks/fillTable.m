% FILLTABLE  Makes the rows of a table of results that do not stand in it yet.
%
% CALL: fillTable (FILE, COLUMNS, LISTS, ROW)
%
%   FILE     path of the table, made where it is not there (startTable)
%   COLUMNS  text, its header
%   LISTS    1 x k cell, each 1 x n numbers or cellstr: what the first k columns
%            take, every combination; the first list changes fastest
%   ROW      handle, CELLS = ROW (VALUE...): the other columns of the row of these
%            k values, texts without commas and numbers
%
% Rows that stand in the table are not made again, so the same call goes on where it
% stopped, and processes share the work, each with a table of its own.
%
% See also: startTable, appendLine

function fillTable (file, columns, lists, row)
  [done, counted] = startTable (file, columns, numel (lists));
  isNumber = cellfun (@isnumeric, lists);
  lists(isNumber) = cellfun (@num2cell, lists(isNumber), 'UniformOutput', false);
  at = cell (size (lists));
  for i = 1:prod (cellfun (@numel, lists))
    [at{:}] = ind2sub ([cellfun(@numel, lists), 1], i);
    key = cellfun (@(list, k) list{k}, lists, at, 'UniformOutput', false);
    if ~any (strcmp (done, rowText (key)))
      appendLine (file, rowText ([key, row(key{:})]));
    end
  end
end

%!test
%! % each combination once, also in the second call
%! file = tempname ();
%! make = @(name, seed) {[name, '!'], seed / 3};
%! evalc ('fillTable (file, ''name,seed,say,x'', {{''a'', ''b''}, 1}, make)');
%! evalc ('fillTable (file, ''name,seed,say,x'', {{''a'', ''b''}, [1, 2]}, make)');
%! list = tableRows (file);
%! assert ({list.name}, {'a', 'b', 'a', 'b'});
%! assert ({list.seed; list.say; list.x}(:, 4), {'2'; 'b!'; '0.6667'});
%! delete (file);

% SPDX-License-Identifier: GPL-3.0-only
