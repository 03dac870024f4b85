% RUNBATCH  Runs sets with effects, those that are not FINE at the first level.
%
% CALL: STATE = runBatch (PROBLEM, STATE, BATCH)
%
%   PROBLEM, STATE     of newProblem, newGapState
%   BATCH              struct theta (n x p, in [-1, 1]), phi (n x K, strengths),
%                      isFine (n x 1 logical; of a case without levels all are)

function state = runBatch (problem, state, batch)
  % modes are where the verdict rests: at the level that counts
  fine = batch.isFine | ~isfield (state.data, 'level');
  stages = {'gap', 'coarse'};
  for at = {fine, ~fine}
    state = spendRuns (state, problem, batch.theta(at{1}, :), ...
                       batch.phi(at{1}, :), ones (sum (at{1}), 1), stages{1});
    stages(1) = [];
  end
end

% SPDX-License-Identifier: GPL-3.0-only
