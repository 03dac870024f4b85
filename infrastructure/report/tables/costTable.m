% COSTTABLE  Statement: the sets with the smallest cost.
%
% CALL: T = costTable (CASE, B)
%
%   CASE  see newCase;  B  see bestKnown
%   T     see newTable

function T = costTable (Case, b)
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

% SPDX-License-Identifier: GPL-3.0-only
