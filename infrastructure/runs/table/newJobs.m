% NEWJOBS  Jobs of a list of parameter sets, one for each set and model.
%
% CALL: JOBS = newJobs (CASE, P, E, REPLICATE, STAGE)
%
%   P          n x d parameter sets
%   E          n x v effect values, columns as CASE.effectVars; [] = neutral
%   REPLICATE  n x 1 or scalar, number of the replicate (1, 2, ...)
%   STAGE      what the runs are for (text): 'plan', 'infill', 'verify' ...
%   JOBS       1 x (n M) struct array, the models of a row side by side:
%              model, stage, planRow (0: none), params, effects, replicate,
%              seed (a prime from 10,007, from params, replicate and
%              Input.seed), key (64 digits, the hash of: input, hash of the
%              model's input, and variables, |name=value of each), origin (case
%              folder), attempt (0; see nextPacking)
%
% Here a set gets the numbers that its run is made with, those of 15 digits
% (toDigits).
%
% Errors: DEcalioc:newJobs:badShape

function jobs = newJobs (Case, P, E, replicate, stage)
  n = rows (P);
  if isempty (E)
    E = repmat (neutralEffects (Case), n, 1);
  end
  if columns (P) ~= numel (Case.names) || rows (E) ~= n
    error ('DEcalioc:newJobs:badShape', ...
           'newJobs: P must be n x %d and E n x %d, got %d x %d, %d x %d.', ...
           numel (Case.names), numel (Case.effectVars), size (P), size (E));
  end
  [P, E] = deal (toDigits (P), toDigits (E));
  replicate = replicate(:) .* ones (n, 1);
  h = hashModels (Case);
  M = numel (Case.models);
  jobs = repmat (struct ('model', '', 'stage', stage, 'planRow', 0, ...
                         'params', [], 'effects', [], 'replicate', 1, ...
                         'seed', 0, 'key', '', 'input', '', ...
                         'variables', '', 'origin', Case.folder, ...
                         'attempt', 0), 1, n * M);
  for i = 1:n
    for k = 1:M
      job = jobs((i - 1) * M + k);
      job.model = Case.models(k).name;
      job.planRow = i * strcmp (stage, 'plan');
      job.params = P(i, :);
      job.effects = E(i, :);
      job.replicate = replicate(i);
      job.seed = jobSeed (job, Case);
      job.input = h(k).input;
      [job.key, job.variables] = ...
        runKey (runVariables (job, Case), Case.effectVars, h(k));
      jobs((i - 1) * M + k) = job;
    end
  end
end

%!test
%! Case = readyCase ();
%! jobs = newJobs (Case, [1, 2; 3, 4], [], [1; 2], 'plan');
%! assert (numel (jobs), 4);
%! assert ({jobs.model}, {'First', 'Second', 'First', 'Second'});
%! assert ([jobs.planRow], [1, 1, 2, 2]);
%! assert (numel (unique ({jobs.key})), 4);
%! again = newJobs (Case, [3, 4], [], 2, 'verify');
%! assert (again(2).key, jobs(4).key);
%!error id=DEcalioc:newJobs:badShape
%! newJobs (readyCase (), [1, 2, 3], [], 1, 'plan');

% SPDX-License-Identifier: GPL-3.0-only
