% JOBSEED  Seed of the run that a job asks for.
%
% CALL: SEED = jobSeed (JOB, CASE [, PARAMS])
%
%   JOB     see newJobs; replicate and attempt are read
%   PARAMS  1 x d (default: those of JOB)
%
% A second attempt at a replicate has a packing of its own, which no replicate
% has: 1.5, 1.75 ... stand for the attempts after the first.

function seed = jobSeed (job, Case, params)
  if nargin < 3
    params = job.params;
  end
  seed = runSeed (params, job.replicate + 1 - 2^-job.attempt, ...
                  Case.options.seed);
end

%!test
%! Case.options.seed = 1;
%! job = struct ('params', [1, 2], 'replicate', 1, 'attempt', 0);
%! seeds = jobSeed (job, Case);
%! assert (seeds, runSeed ([1, 2], 1, 1));
%! for job.attempt = 1:3
%!   seeds(end + 1) = jobSeed (job, Case);
%! end
%! assert (seeds(2), runSeed ([1, 2], 1.5, 1));
%! assert (numel (unique ([seeds, runSeed([1, 2], 2, 1)])), 5);

% SPDX-License-Identifier: GPL-3.0-only
