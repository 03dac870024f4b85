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
  cellOf = @(name, t) struct ('value', {{'calibration', 'sensitivity', name, t}}, 'class', ...
                              repmat ('z2', 1, share.(name)(t) >= 0.3));
  row = @(t) [{targetCell(page, page.Case.targets(t))}, ...
              eachOf(@(name) cellOf (name, t), names)];
  T = newTable (page, 'sensitivity', ...
                'Which parameter drives which result: share of its variance within the limits', ...
                [{'result', '', 'name'}; names(:), ...
                 repmat({'', 'probability'}, numel (names), 1)], ...
                eachOf (row, shownTargets (page.Case)));
end

%!test
%! T = sensitivityTable (situationPage ('met'));
%! assert (size (T.cells), [3, 3]);
%! assert ({T.cells{3, 2}.value, T.cells{3, 2}.class}, {0.5, 'z2'});
%! assert (isempty (sensitivityTable (situationPage ('nothing'))));

% SPDX-License-Identifier: GPL-3.0-only
