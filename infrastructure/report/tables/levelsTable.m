% LEVELSTABLE  Statement: what each level of Input.coarse tells and costs.
%
% CALL: T = levelsTable (PAGE)
%
%   PAGE  see shownResult
%   T     see newTable; [] for a case without levels

function T = levelsTable (page)
  T = [];
  levels = jsonAt (page.sources.calibration, {'levels'});
  if isempty (levels)
    return
  end
  n = numel (levels);
  cells = cell (n, 4);
  for k = 1:n
    level = jsonAt (levels, {k});
    what = 'the level that counts';
    if k < n
      what = levelLine (level, page.Case.targets);
    end
    cells(k, :) = {namedValues({page.Case.coarse.variable}, level.value), ...
                   {'calibration', 'levels', k, 'runs'}, ...
                   {'calibration', 'levels', k, 'seconds'}, what};
  end
  T = newTable (page, 'levels', ...
                'Runs at each level, and what it does to the results with these values', ...
                {'level', '', ''; 'runs', '', 'count'; 'a run', 'core-s', 'plain'; ...
                 'shift', '', 'words'}, cells);
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
%! assert (isempty (levelsTable (situationPage ('met'))));
