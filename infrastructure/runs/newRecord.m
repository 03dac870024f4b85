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
                   'seed', job.seed, 'key', job.key, 'input', '', ...
                   'variables', '', 'origin', '', 'folder', folder, ...
                   'status', 'failed', 'message', '', 'cause', '', ...
                   'results', [], 'seconds', NaN, 'funs', '');
  for name = {'input', 'variables', 'origin'}
    if isfield (job, name{1})            % versions until 0.9 did not note them
      record.(name{1}) = job.(name{1});
    end
  end
end

%!test
%! job = struct ('model', 'M', 'stage', 'plan', 'planRow', 1, 'params', 1, ...
%!               'effects', [], 'replicate', 1, 'seed', 10007, 'key', 'k');
%! assert (newRecord (job, 'f').status, 'failed');
