% PLANSIZE  Plan rows to start with when the user gives no number.
%
% CALL: n = planSize (d)
%
% d  scalar, number of design variables; n  scalar, d + 3
%
% Enough to see which way the responses go. What the plan lacks, infill adds
% where it matters.
%
% See also: planBeside, improveByInfill

function n = planSize (d)
  n = d + 3;
end

%!assert (planSize (5), 8)
