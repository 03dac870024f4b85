% TARGETCELL  A target as the first cell of a row.
%
% CALL: C = targetCell (PAGE, TARGET)
%
%   PAGE    see shownResult
%   TARGET  scalar struct with model and name; role, where it is to be said
%   C       cell of newTable: words of results.csv where there are, code name,
%           unit; the model is its tooltip

function c = targetCell (page, target)
  words = struct ('holdout', ' (not fitted)', 'unmeasured', ' (not measured)');
  mark = givenField (words, givenField (target, 'role', ''), '');
  c = struct ('value', '', 'code', [target.name, mark], 'unit', '', ...
              'title', target.model);
  t = targetAt (page.Case.targets, target);
  if ~isempty (t)
    [c.value, c.unit] = deal (page.targets(t).label, page.targets(t).unit);
  end
  if isempty (c.value)
    c.value = target.name;
  end
  c.value = [c.value, mark];
end

%!test
%! page.Case.targets = struct ('name', {'h', 'w@2'}, 'modelName', 'B');
%! page.targets = struct ('label', {'height of it', ''}, 'unit', {'m', 'kg'});
%! c = targetCell (page, struct ('model', 'B', 'name', 'h', 'role', 'holdout'));
%! assert (c, struct ('value', 'height of it (not fitted)', ...
%!                    'code', 'h (not fitted)', 'unit', 'm', 'title', 'B'));
%! c = targetCell (page, struct ('model', 'B', 'name', 'w@2'));
%! assert ({c.value, c.unit}, {'w@2', 'kg'});
