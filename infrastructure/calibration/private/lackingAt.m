% LACKINGAT  Which results runs near a set lack, that have other results.
%
% CALL: [CHANCE, LACKS, TRIED] = lackingAt (P, DATA, PROBLEM)
%
%   P       1 x d;  DATA  see newData;  PROBLEM  see newProblem
%   CHANCE  1 x T: that more than a quarter of the packings near P lack the result
%           (tooOftenNone); 0 below two that do
%   LACKS, TRIED  1 x T: how many runs near P lack it, of how many; near are the
%           eight nearest sets of each test, with all their packings
%
% A slot that clogs in every second packing, and has no rate then: the packings that
% flow say nothing of the others. So may rows of runs.csv; where a cell is merely empty
% there nobody knows why (NA), and the row counts for neither.

function [chance, lacks, tried] = lackingAt (p, data, problem)
  T = columns (data.Z);
  [lacks, tried] = deal (zeros (1, T));
  data = runsThatCount (data, problem);
  if ~isempty (data.X)
    for k = unique (problem.bench)
      mine = problem.bench == k;
      [isLacking, hasAny] = lackingRows (data.Z(:, mine), problem.bench(mine));
      near = hasAny(:, 1);
      near(near) = isNearest (data.X(near, :), p, problem);
      lacks(mine) = sum (isLacking(near, :), 1);
      tried(mine) = sum (~isna (data.Z(near, mine)), 1);
    end
  end
  chance = tooOftenNone (lacks', tried')';
end

function isNear = isNearest (X, p, problem)
  apart = sumsq (toUnit (X, problem.limits) - toUnit (p, problem.limits), 2);
  far = sort (unique (apart));
  isNear = false (rows (X), 1);
  if ~isempty (far)
    isNear = apart <= far(min (8, end));
  end
end

%!test
%! % two results of one rig and one of another; the second lacks right of 0.5
%! problem = struct ('fine', zeros (1, 0), 'bench', [1, 1, 2], 'limits', [0; 1]);
%! X = linspace (0, 1, 20)';
%! Z = [X, X, X];
%! Z(X > 0.5, 2) = NaN;
%! Z(7, :) = NaN;
%! data = addRows (newData (1, 3), X, Z, ones (20, 1), 'plan');
%! [chance, lacks, tried] = lackingAt (0.8, data, problem);
%! assert ([lacks; tried], [0, 8, 0; 8, 8, 8]);
%! assert (chance([1, 3]), [0, 0]);
%! assert (chance(2) > 0.99);
%! assert (lackingAt (0.2, data, problem), zeros (1, 3));
%! data.stage(:) = {'import'};
%! assert (lackingAt (0.8, data, problem), chance);
%! % nobody knows whether they were looked for
%! data.Z(X > 0.5, 2) = NA;
%! [chance, lacks, tried] = lackingAt (0.8, data, problem);
%! assert ({chance(2), lacks(2), tried(2)}, {0, 0, 0});

% SPDX-License-Identifier: GPL-3.0-only
