% EXECUTESLURM  Carries out runs on a cluster, as job arrays of Slurm.
%
% CALL: RECORDS = executeSlurm (JOBS, CASE, REPORT)
%
%   JOBS, CASE, REPORT, RECORDS  see batchExecute; CASE.options.slurm holds the
%                                fields of batchExecutor, partition and account

function records = executeSlurm (jobs, Case, report)
  records = batchExecute (slurmExecutor (), jobs, Case, report);
end
