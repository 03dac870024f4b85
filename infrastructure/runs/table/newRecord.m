% NEWRECORD  Run record of a job, all fields there, nothing known yet.
%
% CALL: RECORD = newRecord (JOB, FOLDER)
%
%   JOB     see newJobs
%   FOLDER  folder of the run (text)
%   RECORD  the job's fields, and:
%     folder    run folder; owner: id of the case (decalioc.id)
%     status    'ok'; 'failed' (broke off); 'timeout'; 'invalid' (unusable
%               results); 'forgotten' (by decalioc forget)
%     message   what happened, with the first line of output that complains
%     cause     '', 'exit', 'killed' (from outside), 'time', 'output', 'none' (no
%               result is a number), 'lacking' (one is none, status 'ok'),
%               'evaluation' (an error in getResults, or results that are there
%               though the script ended with another status than 0), 'budget'
%               (not run: Input.maxNewRuns), 'stage' (the run that it starts from failed;
%               folder is that of it)
%     results   1 x m; NaN: not a number in this run; may be empty unless 'ok'
%     seconds   wall-clock time of the simulation
%     funs      hash of OctaveFuns/ and, with measured.csv, of the results and
%               places that it reads
%     readings  answers to other questions (of other cases, or before a change):
%               funs, status, message, cause, results; the last 50

function record = newRecord (job, folder)
  record = struct ('model', job.model, 'stage', job.stage, ...
                   'planRow', job.planRow, 'params', job.params, ...
                   'effects', job.effects, 'replicate', job.replicate, ...
                   'seed', job.seed, 'key', job.key, ...
                   'input', job.input, ...
                   'variables', job.variables, ...
                   'origin', job.origin, ...
                   'owner', givenField (job, 'owner', ''), ...
                   'folder', folder, 'status', 'failed', 'message', '', ...
                   'cause', '', 'results', [], 'seconds', NaN, 'funs', '');
end

%!assert (newRecord (standInJob (), 'f').status, 'failed');

% SPDX-License-Identifier: GPL-3.0-only
