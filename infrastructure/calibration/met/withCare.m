% WITHCARE  What runs tell of sets beside their results, for meetProbability.
%
% CALL: PROBLEM = withCare (STATE, PROBLEM)
%
%   PROBLEM  with avoid (see failedSets) and odd (see oddRuns)

function problem = withCare (state, problem)
  problem.avoid = failedSets (state.data, problem);
  problem.odd = oddRuns (state, problem);
end

%!test
%! [problem, state] = smallCalibration ();
%! problem = withCare (state, problem);
%! assert ({rows(problem.avoid), problem.odd}, {0, []});

% SPDX-License-Identifier: GPL-3.0-only
