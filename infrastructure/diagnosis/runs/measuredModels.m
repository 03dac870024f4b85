% MEASUREDMODELS  Models of a case with a reading of the state that is diagnosed.
%
% CALL: YES = measuredModels (CASE [, C])
%
%   CASE  see newCase;  C  numbers of its conditions (default: all)
%   YES   1 x M logical; all where no condition is compared with a reference
%
% Of a change a run of what was never measured in the new state says nothing that a
% reading could be compared with.

function yes = measuredModels (Case, c)
  yes = true (1, numel (Case.models));
  conditions = givenField (Case, 'conditions', {});
  if isempty (conditions)
    return
  end
  if nargin < 2
    c = 1:numel (conditions);
  end
  isRead = arrayfun (@(t) any (isfinite ([t.changed(c).value])), Case.targets);
  yes = ismember (1:numel (Case.models), [Case.targets(isRead).model]);
end

%!test
%! Case.models = struct ('name', {'A', 'B', 'C'});
%! both = struct ('value', {1, NaN});
%! Case.targets = struct ('model', {1, 2, 3}, 'changed', {both, both([2, 1]), both([2, 2])});
%! assert (measuredModels (Case), [true, true, true]);
%! Case.conditions = {'moist', 'wet'};
%! assert (measuredModels (Case), [true, true, false]);
%! assert (measuredModels (Case, 2), [false, true, false]);

% SPDX-License-Identifier: GPL-3.0-only
