% NEXTTABLE  Statement: what can be measured next, and what it would tell.
%
% CALL: T = nextTable (PAGE)
%
%   PAGE  see shownResult
%   T     see newTable, ten tests at most; [] without a diagnosis

function T = nextTable (page)
  tests = jsonAt (page.sources.gap, {'next'});
  n = min (numel (tests), 10);
  cells = cell (n, 3);
  for k = 1:n
    cells(k, :) = {nthargout(2, @nextText, jsonAt (tests, {k})), ...
                   {'gap', 'next', k, 'gain'}, {'gap', 'next', k, 'cost'}};
  end
  notes = {sentence('table.next')};
  if n > 0 && jsonAt (tests, {1, 'gain'}) < thresholdOf (page.sources.gap, 'adviseAt', 0.2)
    notes = [{sentence('table.nextLittle')}, notes];
  end
  T = newTable (page, 'next', 'What can be measured next, the best first', ...
                {'test', '', 'words'; 'gain', 'bit', 'probability'; 'cost', '', 'plain'}, ...
                cells, notes);
end

%!test
%! T = nextTable (situationPage ('missed, named'));
%! assert (T.cells{1, 1}.value, 'measure First once more');
%! assert (T.notes{1}, sentence ('table.nextLittle'));
