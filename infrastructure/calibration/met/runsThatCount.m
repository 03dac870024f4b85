% RUNSTHATCOUNT  The rows of a table that were run as PROBLEM.fine says.
%
% CALL: DATA = runsThatCount (DATA, PROBLEM)
%
%   DATA     see newData;  PROBLEM  see newProblem

function data = runsThatCount (data, problem)
  data = keepRows (data, all (data.E == problem.fine, 2));
end

%!test
%! data = addRows (newData (1, 1, 1), [1; 2], [3; 4], [1; 1], 'plan', [2; 1]);
%! kept = runsThatCount (data, struct ('fine', 1));
%! assert ({kept.X, kept.E, kept.Z, kept.stage}, {2, 1, 4, {'plan'}});
%! data.E = zeros (2, 0);
%! assert (runsThatCount (data, struct ('fine', zeros (1, 0))), data);

% SPDX-License-Identifier: GPL-3.0-only
