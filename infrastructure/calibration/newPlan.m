% NEWPLAN  The plan of a case, besides the runs that were taken in.
%
% CALL: [PLAN, E] = newPlan (DATA, CASE)
%
%   DATA  see newData: the runs that were taken in
%   PLAN  n x d: CASE.options.numOfSam rows less the finished sets of DATA; none
%         where there is no model to run
%   E     n x v, levels of the rows (columns as CASE.effectVars); v is 0 where
%         the case has no levels
%
% A Latin hypercube plan; beside runs that were taken in, rows far from them.
% Where they are of a library, only as many as its runs near the box leave bare:
% farther from them than the plan alone would leave a place; and not fewer than
% surrogates need.
%
% With levels (CASE.coarse) all these rows are run at the first, the cheapest
% level; the others come where these runs find the set (improveByInfill).

function [plan, E] = newPlan (data, Case)
  n = max (0, Case.options.numOfSam - tellingSets (data, Case.limits));
  if any (cellfun (@isempty, {Case.models.folder}))
    n = 0;
  end
  if any (strcmp (data.stage, 'library'))
    least = columns (data.X) + 1 - tellingSets (data);
    plan = planBeside (data.X, n, Case, least);
  else
    plan = planBeside (insideLimits (data.X, Case.limits), n, Case);
  end
  E = zeros (rows (plan), 0);
  if ~isempty (givenField (Case, 'coarse', []))
    levels = vertcat (Case.coarse.levels)';
    E = repmat (levels(1, :), rows (plan), 1);
  end
end

% Where most sets have one value of a parameter, as those from before it was one, the
% others are what the runs tell of it.
function n = tellingSets (data, varargin)
  n = finishedSets (data, varargin{:});
  X = unique (data.X, 'rows');
  if rows (X) > 1
    same = arrayfun (@(j) sum (X(:, j) == mode (X(:, j))), 1:columns (X));
    isMostly = same > rows (X) / 2;      % all of them: replicates of one set
    n = max (0, n - max ([0, same(isMostly & ~all (isMostly))]));
  end
end

%!shared data, Case
%! Case = struct ('limits', [0; 1], 'folder', '');
%! Case.options = struct ('numOfSam', 5, 'seed', 1);
%! Case.models = struct ('folder', {'a', 'b'});
%! data = newData (1, 2);

%!test
%! assert (rows (newPlan (data, Case)), 5);
%! some = addRows (data, [0.1; 0.2; 3], [1, 2; NaN, 3; 4, 5], ones (3, 1), ...
%!                 'import');
%! plan = newPlan (some, Case);
%! assert (rows (plan), 4);
%! some = addRows (some, 0.1 * ones (9, 1), ones (9, 2), (2:10)', 'import');
%! assert (rows (newPlan (some, Case)), 4);
%! assert (all (abs (plan - 0.15) > 0.1));
%! none = setfield (Case, 'models', {2}, 'folder', '');
%! assert (size (newPlan (some, none)), [0, 1]);

%!test
%! % runs from before a parameter was one tell nothing of it
%! Case.limits = [0, 0; 1, 1];
%! some = addRows (newData (2, 2), [(0:5)' / 5, 0 * ones(6, 1)], ones (6, 2), ones (6, 1), ...
%!                 'library');
%! plan = newPlan (some, Case);
%! assert (rows (plan), 5);
%! some = addRows (some, [0.3, 0.7], [1, 1], 1, 'library');
%! assert (rows (newPlan (some, Case)), 3);
%! assert (max (plan(:, 2)) - min (plan(:, 2)) > 0.3);
%!test
%! % the plan of a larger case beside runs of a smaller one draws no row twice
%! old = GenerateExperPlan ([0; 1], 4, '', 1);
%! some = addRows (data, old, [old, old], ones (4, 1), 'import');
%! larger = setfield (Case, 'options', 'numOfSam', 8);
%! plan = newPlan (some, larger);
%! assert (rows (plan), 4);
%! assert (isempty (intersect (plan, old)));

%!test
%! % with levels: the rows at the cheapest one
%! Case.coarse = struct ('levels', [3, 2, 1]);
%! data = newData (1, 2, 1);
%! [plan, E] = newPlan (data, Case);
%! assert (E, 3 * ones (rows (plan), 1));
%! data = addRows (data, [0.2; 0.4], [1, 2; 3, 4], [1; 1], 'import', [3; 1]);
%! [rest, E] = newPlan (data, Case);
%! assert (E, 3 * ones (rows (plan) - 2, 1));

% SPDX-License-Identifier: GPL-3.0-only
