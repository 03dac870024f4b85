% NEXTPACKING  The same run with the next seed: another packing.
%
% CALL: JOB = nextPacking (JOB, CASE)
%
%   JOB   scalar struct, see newJobs; seed, key, variables and attempt change
%   CASE  see newCase
%
% For a run that failed by itself, and for one that the user has taken out of
% use: with its seed it would come back to the last digit.

function job = nextPacking (job, Case)
  h = hashModels (Case)(strcmp (job.model, {Case.models.name}));
  job.attempt = job.attempt + 1;
  job.seed = jobSeed (job, Case);
  [job.key, job.variables] = runKey (runVariables (job, Case), ...
                                     Case.effectVars, h);
end

%!test
%! Case = readyCase ();
%! job = newJobs (Case, [1, 2], [], 1, 'plan')(1);
%! other = nextPacking (job, Case);
%! assert (~isequal (other.key, job.key) && other.seed ~= job.seed);
%! assert (other.seed, runSeed ([1, 2], 1.5, Case.options.seed));
%! changed = {'seed', 'key', 'variables', 'attempt'};
%! assert (isequal (rmfield (other, changed), rmfield (job, changed)));

% SPDX-License-Identifier: GPL-3.0-only
