% JSONLIST  A list deep inside decoded JSON as a cell.
%
% CALL: LIST = jsonList (ROOT, PATH)
%
%   ROOT, PATH  see jsonAt
%   LIST        1 x n cell of its elements: structs or numbers; a text is one
%               element; empty where there is no list

function list = jsonList (root, path)
  list = jsonAt (root, path);
  if ischar (list)
    list = cellstr (list);
    if strcmp (list, '')
      list = {};
    end
  elseif ~iscell (list)
    list = num2cell (list);
  end
  list = reshape (list, 1, []);
end

%!assert (jsonList (struct ('a', struct ('b', {1, 2})), {'a'}), {struct('b', 1), struct('b', 2)})
%!assert (jsonList (struct ('a', {{1, 'x'}}), {'a'}), {1, 'x'})
%!assert (jsonList (struct ('a', 'x'), {'a'}), {'x'})
%!assert (jsonList ([], {'a'}), cell (1, 0))

% SPDX-License-Identifier: GPL-3.0-only
