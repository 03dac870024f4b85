% FAILURESTABLE  Statement: why runs failed.
%
% CALL: T = failuresTable (PAGE)
%
%   PAGE  see pageData
%   T     see newTable, the most frequent reason first, 20 at most; no rows for none

function T = failuresTable (page)
  bad = givenField (page, 'runs', struct ('status', {}, 'message', {}));
  bad = bad(~ismember ({bad.status}, {'ok', 'not ended'}));
  reasons = strcat ({bad.status}, {': '}, {bad.message});
  [kinds, first, number] = unique (reasons, 'first');
  count = accumarray (number(:), 1, [numel(kinds), 1]);
  [~, order] = sort (-count);
  row = @(k) {kinds{k}, count(k), [bad(first(k)).model, '/', bad(first(k)).name]};
  T = newTable (page, 'failures', 'Why runs failed, the most frequent reason first', ...
                {'reason', '', 'words'; 'runs', '', 'count'; 'first of them', '', ''}, ...
                eachOf (row, order(1:min (end, 20))));
end

%!test
%! page.runs = struct ('model', 'M', 'name', {'1', '2', '3', '4'}, 'status', ...
%!                     {'failed', 'failed', 'ok', 'timeout'}, 'message', {'x', 'x', '', 'y'});
%! page.sources = [];
%! T = failuresTable (page);
%! assert (cellfun (@(c) c.value, T.cells(:, 2))', [2, 1]);
%! assert (T.cells{1, 3}.value, 'M/1');

% SPDX-License-Identifier: GPL-3.0-only
