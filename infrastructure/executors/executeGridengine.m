% EXECUTEGRIDENGINE  Carries out runs on a cluster, as jobs of Grid Engine.
%
% CALL: RECORDS = executeGridengine (JOBS, CASE, REPORT)
%
%   JOBS, CASE, REPORT, RECORDS  see batchExecute; CASE.options.gridengine holds
%                                the fields of batchExecutor, queue, project and
%                                environment

function records = executeGridengine (jobs, Case, report)
  records = batchExecute (gridengineExecutor (), jobs, Case, report);
end
