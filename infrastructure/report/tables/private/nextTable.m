% NEXTTABLE  Statement: what can be measured next, and what it would tell.
%
% CALL: T = nextTable (PAGE)
%
%   PAGE  see shownResult
%   T     see newTable, ten tests at most; no rows without a diagnosis

function T = nextTable (page)
  tests = jsonList (page.sources.gap, {'next'});
  row = @(k) {nthargout(2, @nextText, tests{k}), {'gap', 'next', k, 'gain'}, ...
              {'gap', 'next', k, 'cost'}};
  notes = {sentence('table.nextLittle'), sentence('table.next')};
  isLittle = isequal (jsonNumber (tests, {1, 'gain'}) < ...
                      jsonAt (page.sources.gap, {'thresholds', 'adviseAt'}), true);
  T = newTable (page, 'next', 'What can be measured next, the best first', ...
                {'test', '', 'words'; 'gain', 'bit', 'probability'; 'cost', '', 'plain'}, ...
                eachOf (row, 1:min (numel (tests), 10)), notes(2 - isLittle:end));
end

%!test
%! T = nextTable (situationPage ('missed, named'));
%! assert (T.cells{1, 1}.value, 'measure First once more');
%! assert (T.notes{1}, sentence ('table.nextLittle'));

% SPDX-License-Identifier: GPL-3.0-only
