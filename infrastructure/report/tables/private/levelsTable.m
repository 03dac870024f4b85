% LEVELSTABLE  Statement: what each level of Input.coarse tells and costs.
%
% CALL: T = levelsTable (PAGE)
%
%   PAGE  see shownResult
%   T     see newTable; no rows for a case without levels

function T = levelsTable (page)
  levels = jsonList (page.sources.calibration, {'levels'});
  n = numel (levels);
  shifts = [eachOf(@(level) levelLine (level, page.Case.targets), levels(1:n - 1)), ...
            {'the level that counts'}];
  row = @(k) {namedValues({page.Case.coarse.variable}, levels{k}.value), ...
              {'calibration', 'levels', k, 'runs'}, ...
              {'calibration', 'levels', k, 'seconds'}, shifts{k}};
  T = newTable (page, 'levels', ...
                'Runs at each level, and what it does to the results with these values', ...
                {'level', '', ''; 'runs', '', 'count'; 'a run', 'core-s', 'plain'; ...
                 'shift', '', 'words'}, eachOf (row, 1:n));
end

%!test
%! page = situationPage ('met');
%! page.Case.coarse = struct ('variable', 'size');
%! blank = struct ('value', {2, 1}, 'runs', {5, 7}, 'seconds', {1, 8}, 'shift', {[1, 2, 3], []}, ...
%!                 'shiftSd', {[1, 1, 1], []}, 'dropped', {[0, 0, 0], []});
%! page.sources.calibration.levels = blank;
%! T = levelsTable (page);
%! assert (T.cells{2, 4}.value, 'the level that counts');
%! assert ({T.cells{1, 1}.value, T.cells{1, 2}.value}, {'size = 2', 5});
%! assert (isempty (levelsTable (situationPage ('met')).cells));

% SPDX-License-Identifier: GPL-3.0-only
