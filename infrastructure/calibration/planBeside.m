% PLANBESIDE  Plan of further sets, beside those that there are.
%
% CALL: PLAN = planBeside (X, N, CASE)
%       PLAN = planBeside (X, N, CASE, LEAST)
%
%   X     m x d, sets that were run; m may be 0
%   N     number of sets to add
%   PLAN  N x d: a Latin hypercube, kept in ExperimentalPlan_DoE.csv; beside
%         sets that there are, rows as far as possible from them
%   LEAST  only so many rows, but those too that are farther from all X than the
%         plan of the case alone would leave a place

function plan = planBeside (X, n, Case, least)
  if isempty (X)
    plan = newPlanOf (n, Case);
  else
    [plan, gap] = augmentPlan (X, n, Case);
    if nargin > 3
      [~, alone] = augmentPlan (X([], :), Case.options.numOfSam + 1, Case);
      isBare = gap > alone(end) | (1:rows (gap))' <= least;
      plan = plan(isBare, :);
    end
  end
end

function plan = newPlanOf (n, Case)
  if isempty (givenField (Case, 'allowed', []))
    plan = GenerateExperPlan (Case.limits, n, Case.folder, Case.options.seed);
  else
    plan = augmentPlan (zeros (0, columns (Case.limits)), n, Case);
  end
end

% Greedy maximin in the unit box over a space-filling sample; the distance to
% the walls counts half a step, so rows do not crowd there. Fewer than N rows
% where there are not so many allowed sets.
function [P, gap] = augmentPlan (X, n, Case)
  U = toUnit (X, Case.limits);
  C = candidates (Case);
  if ~isempty (givenField (Case, 'allowed', []))
    n = min (n, rows (C));
  end
  wall = 2 * min (min (C, 1 - C), [], 2);
  [at, gap] = farPoints (C, U, n, wall);
  P = fromUnit (C(at, :), Case.limits);
end

% Sets to choose from, in the unit box.
function C = candidates (Case)
  d = columns (Case.limits);
  C = sampleBox (2000, [zeros(1, d); ones(1, d)]);
  if ~isempty (givenField (Case, 'allowed', []))
    [yes, P] = isAllowed (fromUnit (C, Case.limits), Case);
    P = unique ([P(yes, :); Case.allowed.sample], 'rows', 'stable');
    C = toUnit (P, Case.limits);
  end
end

%!test
%! Case = struct ('limits', [0; 1], 'folder', '');
%! Case.options.seed = 3;
%! assert (planBeside (zeros (0, 1), 5, Case), ...
%!         GenerateExperPlan ([0; 1], 5, '', 3));
%! % the gap is filled first
%! Case.limits = [0; 10];
%! assert (planBeside ([1; 2; 3; 9], 1, Case), 6, 0.4);
%! % one half is bare; both are full, but so many rows are needed
%! Case.options.numOfSam = 5;
%! plan = planBeside ((0:0.5:5)', 5, Case, 0);
%! assert (rows (plan) < 5 && all (plan > 5.5));
%! assert (rows (planBeside ((0:0.5:10)', 5, Case, 0)), 0);
%! assert (rows (planBeside ((0:0.5:10)', 5, Case, 2)), 2);

% SPDX-License-Identifier: GPL-3.0-only
