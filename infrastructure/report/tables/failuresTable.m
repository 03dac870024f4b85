% FAILURESTABLE  Statement: why runs failed.
%
% CALL: T = failuresTable (PAGE)
%
%   PAGE  see pageData
%   T     see newTable, the most frequent reason first, 20 at most; [] for none

function T = failuresTable (page)
  T = [];
  runs = givenField (page, 'runs', []);
  if isempty (runs)
    return
  end
  bad = runs(~ismember ({runs.status}, {'ok', 'not ended'}));
  if isempty (bad)
    return
  end
  reasons = strcat ({bad.status}, {': '}, {bad.message});
  [kinds, first, number] = unique (reasons, 'first');
  count = accumarray (number(:), 1);
  [~, order] = sort (-count);
  order = order(1:min (end, 20))';
  places = strcat ({bad(first(order)).model}, '/', {bad(first(order)).name});
  T = newTable (page, 'failures', 'Why runs failed, the most frequent reason first', ...
                {'reason', '', 'words'; 'runs', '', 'count'; 'first of them', '', ''}, ...
                [kinds(order)(:), num2cell(count(order)(:)), places(:)]);
end

%!test
%! page.runs = struct ('model', 'M', 'name', {'1', '2', '3', '4'}, 'status', ...
%!                     {'failed', 'failed', 'ok', 'timeout'}, 'message', {'x', 'x', '', 'y'});
%! page.sources = [];
%! T = failuresTable (page);
%! assert (cellfun (@(c) c.value, T.cells(:, 2))', [2, 1]);
%! assert (T.cells{1, 3}.value, 'M/1');
