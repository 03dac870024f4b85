% NEWRECORD  Run record of a job, all fields there, nothing known yet.
%
% CALL: RECORD = newRecord (JOB, FOLDER)
%
%   JOB     see newJobs
%   FOLDER  folder of the run (text)
%   RECORD  the job's fields, and: folder, status ('ok', 'failed', 'timeout',
%           'invalid'), message, cause, results (1 x m), seconds, funs (hash
%           of the evaluation that made the results)

function record = newRecord (job, folder)
  record = struct ('model', job.model, 'stage', job.stage, ...
                   'planRow', job.planRow, 'params', job.params, ...
                   'effects', job.effects, 'replicate', job.replicate, ...
                   'seed', job.seed, 'key', job.key, 'folder', folder, ...
                   'status', 'failed', 'message', '', 'cause', '', ...
                   'results', [], 'seconds', NaN, 'funs', '');
end

%!test
%! job = struct ('model', 'M', 'stage', 'plan', 'planRow', 1, 'params', 1, ...
%!               'effects', [], 'replicate', 1, 'seed', 10007, 'key', 'k');
%! assert (newRecord (job, 'f').status, 'failed');
