% TARGETCELL  A target as the first cell of a row.
%
% CALL: C = targetCell (PAGE, TARGET)
%
%   PAGE    see shownResult
%   TARGET  scalar struct with model (or modelName) and name; role, where it is said
%   C       cell of newTable: words of results.csv where there are, code name,
%           unit; the model is its tooltip. A result that was measured in another
%           unit than that of results.csv has the one of measured.csv, and factor

function c = targetCell (page, target)
  words = struct ('holdout', ' (not fitted)', 'unmeasured', ' (not measured)');
  mark = givenField (words, givenField (target, 'role', ''), '');
  if isfield (target, 'modelName')
    target.model = target.modelName;
  end
  known = struct ('label', '', 'unit', '');
  t = targetAt (page.Case.targets, target);
  if ~isempty (t)
    known = page.targets(t);
  end
  code = [target.name, mark];
  c = struct ('value', givenField (known, 'label', code), 'code', code, ...
              'unit', known.unit, 'title', target.model);
  if ~isempty (t) && page.Case.targets(t).shown.factor ~= 1
    shown = page.Case.targets(t).shown;
    [c.unit, c.factor] = deal (shown.unit, 1 / shown.factor);
  end
end

%!test
%! page.Case.targets = struct ('name', {'h', 'w@2'}, 'modelName', 'B', 'shown', ...
%!                            struct ('unit', '', 'factor', 1));
%! page.targets = struct ('label', {'height of it', ''}, 'unit', {'m', 'kg'});
%! c = targetCell (page, struct ('model', 'B', 'name', 'h', 'role', 'holdout'));
%! assert (c, struct ('value', 'height of it', ...
%!                    'code', 'h (not fitted)', 'unit', 'm', 'title', 'B'));
%! c = targetCell (page, struct ('model', 'B', 'name', 'w@2'));
%! assert ({c.value, c.unit}, {'w@2', 'kg'});
%! assert (targetCell (page, struct ('model', 'B', 'name', 'z', 'role', 'holdout')).value, ...
%!         'z (not fitted)');
%! page.Case.targets(2).shown = struct ('unit', 'g', 'factor', 1e-3);
%! c = targetCell (page, struct ('model', 'B', 'name', 'w@2'));
%! assert ({c.unit, c.factor}, {'g', 1000}, 1e-9);

% SPDX-License-Identifier: GPL-3.0-only
