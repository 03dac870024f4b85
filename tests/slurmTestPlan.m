% SLURMTESTPLAN  Runs a plan through Slurm; for an Octave that will be killed.
%
% CALL: slurmTestPlan (FOLDER, A, SECONDS)
%
%   arguments as in slurmTestCase
%
% See also: slurmTestStart

function slurmTestPlan (folder, a, seconds)
  [Case, jobs] = slurmTestCase (folder, a, seconds);
  Case.options.executor = 'slurm';
  runJobs (jobs, Case, @(state) []);
end
