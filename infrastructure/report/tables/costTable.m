% COSTTABLE  Statement: the sets with the smallest cost.
%
% CALL: [T, TEXTS] = costTable (CASE, B)
%
%   CASE   see newCase;  B  see bestKnown
%   T      see newTable
%   TEXTS  1 x n cell of sentences: what is said of the best set known, where a cost
%          is all there is

function [T, texts] = costTable (Case, b)
  texts = costTexts (b);
  sets = [{b}, b.next];
  [labels, units] = paramLabels (Case);
  d = numel (Case.names);
  cells = cell (numel (sets), d + 3);
  for k = 1:numel (sets)
    values = cellfun (@(n) sets{k}.params.(n), Case.names, 'UniformOutput', false);
    cells(k, :) = [{sprintf('%d', k)}, values, {sets{k}.cost, sets{k}.runs}];
  end
  columns = [{'rank', '', ''}; ...
             [Case.names(:), units(:), repmat({'plain'}, d, 1)]; ...
             {b.name, '', 'plain'; 'runs', '', 'count'}];
  T = newTable (struct ('sources', struct ()), 'best', ...
                ['Sets with the smallest ', b.name], columns, cells);
end

function texts = costTexts (b)
  texts = {['There is no interval, no probability and no diagnosis: one number a ' ...
            'run does not tell which result misses, nor how runs scatter.']};
  if b.runs > 1
    texts{end + 1} = sprintf ('The cost is the mean of %d runs.', b.runs);
  else
    texts{end + 1} = ['It is the luckiest of one run a set: run these values again ' ...
                      'with another packing.'];
  end
  if b.failed + b.outside > 0
    texts{end + 1} = sprintf ('Not counted: %s without a cost, %s beyond the limits.', ...
                              countText (b.failed, 'row'), countText (b.outside, 'set'));
  end
  texts{end + 1} = ['To know more, put the results that the cost is made of into ' ...
                    'runs.csv, a column each, and their measured values into ' ...
                    'loadInput.m.'];
end

%!test
%! Case = readyCase ();
%! b = struct ('name', 'cost', 'cost', 2, 'runs', 1, 'failed', 0, 'outside', 0, ...
%!             'params', struct ('a', 1, 'b', 2));
%! b.next = {setfield(b, 'cost', 3)};
%! [T, texts] = costTable (Case, b);
%! assert (size (T.cells), [2, 5]);
%! assert (numel (texts), 3);
%! [b.runs, b.failed] = deal (3, 1);
%! [~, texts] = costTable (Case, b);
%! assert (numel (texts), 4);

% SPDX-License-Identifier: GPL-3.0-only
