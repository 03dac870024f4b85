% FAILEDSETS  Sets whose runs failed twice or more, and never or seldom finished.
%
% CALL: P = failedSets (DATA, PROBLEM)
%
% P        k x d, where runs surely end without a result too often (tooOftenNone)

function P = failedSets (data, problem)
  data = runsThatCount (data, problem);
  counts = ~strcmp (data.stage, 'import') & ...
           ~(strcmp (data.stage, 'library') & any (isna (data.Z), 2));
  [sets, ~, group] = unique (data.X(counts, :), 'rows');
  failed = any (isnan (data.Z(counts, :)), 2);
  n = accumarray (group(:), 1, [rows(sets), 1]);
  bad = accumarray (group(:), failed(:), [rows(sets), 1]);
  P = sets(tooOftenNone (bad, n) > 0.95, :);
end

%!test
%! problem.fine = zeros (1, 0);
%! data = addRows (newData (1, 1), [1; 1; 2; 2; 3], ...
%!                 [NaN; NaN; 1; NaN; NaN], ones (5, 1), 'plan');
%! assert (failedSets (data, problem), 1);
%! data.stage(2) = {'import'};
%! assert (isempty (failedSets (data, problem)));
%! data.stage(1:2) = {'library'};
%! assert (failedSets (data, problem), 1);
%! data.Z(2) = NA;
%! assert (isempty (failedSets (data, problem)));

% SPDX-License-Identifier: GPL-3.0-only
