% RUNVARIABLES  All variables that a run writes into its data.head.
%
% CALL: V = runVariables (JOB, CASE)
%
%   JOB   see newJobs
%   CASE  see newCase
%   V     scalar struct: model variables, design variables, effect variables,
%         RLTS, SIMTS, runSeed; as they are, see headLines and runKey

function v = runVariables (job, Case)
  v = Case.modelVars;
  for k = 1:numel (Case.effectVars)
    v.(Case.effectVars{k}) = job.effects(k);
  end
  v = assignParams (v, job.params, Case.names);
  v.runSeed = job.seed;
end

%!test
%! Case = struct ('modelVars', struct ('c', 3), 'effectVars', {{'e'}}, ...
%!                'names', {{'a', 'b'}});
%! job = struct ('params', [1, 2], 'effects', 5, 'seed', 10007);
%! v = runVariables (job, Case);
%! assert (v, struct ('c', 3, 'e', 5, 'a', 1, 'b', 2, 'runSeed', 10007));

% SPDX-License-Identifier: GPL-3.0-only
