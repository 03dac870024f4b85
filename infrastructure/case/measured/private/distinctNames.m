% DISTINCTNAMES  Names of targets that no two models share.
%
% CALL: GROUPS = distinctNames (GROUPS, MODELS, FURTHER)
%
%   GROUPS, MODELS, FURTHER  see groupMeasured
%
% Where several models have a target of one name, it is <model>_<name>: a name
% is a column of runs.csv, so further models leave those of the others as they
% are.

function groups = distinctNames (groups, models, further)
  names = {groups.name};
  of = [groups.model];
  if all (of == of(1))
    return
  end
  isLate = of > 0;
  isLate(isLate) = ismember (models(of(isLate)), further);
  for k = find (of > 0)
    if any (strcmp (names, names{k}) & of ~= of(k) & isLate <= isLate(k))
      groups(k).name = [models{of(k)}, '_', names{k}];
    end
  end
end

%!test
%! g = struct ('name', {'a', 'b', 'a'}, 'model', {1, 1, 2});
%! assert ({distinctNames(g, {'M', 'N'}, {}).name}, {'M_a', 'b', 'N_a'});
%! assert ({distinctNames(g, {'M', 'N'}, {'N'}).name}, {'a', 'b', 'N_a'});
%! assert (distinctNames (g(1:2), {'M', 'N'}, {}), g(1:2));

% SPDX-License-Identifier: GPL-3.0-only
