% PLANSIZE  Plan rows to start with when the user gives no number.
%
% CALL: n = planSize (d)
%
% d  scalar, number of design variables; n  scalar, 2 d + 2
%
% An affine trend has d + 1 terms; as many runs again estimate the noise. What
% the plan lacks, infill adds where it matters.
%
% See also: augmentPlan, improveByInfill

function n = planSize (d)
  n = 2 * d + 2;
end

%!assert (planSize (5), 12)
