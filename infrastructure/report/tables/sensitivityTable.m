% SENSITIVITYTABLE  Statement: which parameter drives which result.
%
% CALL: T = sensitivityTable (PAGE)
%
%   PAGE  see shownResult
%   T     see newTable, a row a result, as there are more of them; [] without a
%         calibration

function T = sensitivityTable (page)
  T = [];
  names = page.Case.names;
  share = jsonAt (page.sources.calibration, {'sensitivity'});
  if isempty (share) || ~all (isfield (share, names))
    return
  end
  shown = shownTargets (page.Case);
  cells = cell (numel (shown), numel (names) + 1);
  for i = 1:numel (shown)
    t = shown(i);
    one = page.Case.targets(t);
    own = struct ('model', one.modelName, 'name', one.name, 'role', one.role);
    cells{i, 1} = targetCell (page, own);
    for j = 1:numel (names)
      isMuch = share.(names{j})(t) >= 0.3;
      cells{i, j + 1} = struct ('value', {{'calibration', 'sensitivity', names{j}, t}}, ...
                                'class', repmat ('z2', 1, isMuch));
    end
  end
  columns = [{'result', '', 'name'}; names(:), repmat({'', 'probability'}, numel (names), 1)];
  T = newTable (page, 'sensitivity', ...
                'Which parameter drives which result: share of its variance within the limits', ...
                columns, cells);
end

%!test
%! T = sensitivityTable (situationPage ('met'));
%! assert (size (T.cells), [3, 3]);
%! assert ({T.cells{3, 2}.value, T.cells{3, 2}.class}, {0.5, 'z2'});
%! assert (isempty (sensitivityTable (situationPage ('nothing'))));
