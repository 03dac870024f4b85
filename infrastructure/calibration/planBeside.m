% PLANBESIDE  Plan of further sets, beside those that there are.
%
% CALL: PLAN = planBeside (X, N, CASE)
%
%   X     m x d, sets that were run; m may be 0
%   N     number of sets to add
%   CASE  see newCase
%   PLAN  N x d: a Latin hypercube, kept in ExperimentalPlan_DoE.csv; beside
%         sets that there are, rows as far as possible from them
%
% See also: newPlan, completePlan, GenerateExperPlan, augmentPlan

function plan = planBeside (X, n, Case)
  if isempty (X)
    plan = GenerateExperPlan (Case.limits, n, Case.folder, Case.options.seed);
  else
    plan = augmentPlan (X, n, Case.limits);
  end
end

%!test
%! pkg load stk
%! Case = struct ('limits', [0; 1], 'folder', '');
%! Case.options.seed = 3;
%! assert (planBeside (zeros (0, 1), 5, Case), ...
%!         GenerateExperPlan ([0; 1], 5, '', 3));
%! assert (planBeside ([0.1; 0.9], 1, Case), 0.5, 0.1);
