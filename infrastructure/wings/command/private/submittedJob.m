% SUBMITTEDJOB  The job in which decalioc submit has the main program work.
%
% CALL: [JOB, STATE] = submittedJob (FOLDER)
%
%   FOLDER  case folder (text)
%   JOB     scalar struct: executor, name (its name in the queue); [] where
%           there is none
%   STATE   'waiting', 'running', 'gone', or 'unknown' where the queue does not
%           answer; 'none' without a job

function [job, state] = submittedJob (folder)
  job = [];
  state = 'none';
  words = strsplit (strtrim (readText (fullfile (folder, 'submitted', 'job'))));
  if numel (words) ~= 2 || ~any (strcmp (words{1}, executorNames ()))
    return
  end
  job = struct ('executor', words{1}, 'name', words{2});
  queue = describeExecutor (job.executor);
  [answers, ~, tasks] = queue.look ({job.name}, 1);
  state = merge (answers, 'gone', 'unknown');
  if answers && any (tasks.state == 'pr')
    state = merge (tasks.state == 'r', 'running', 'waiting');
  end
end

%!test
%! folder = emptyFolder ();
%! [job, state] = submittedJob (folder);
%! assert ({job, state}, {[], 'none'});
%! mkdir (fullfile (folder, 'submitted'));
%! writeAtomic (fullfile (folder, 'submitted', 'job'), "slurm decalioc-a\n");
%! for given = {'echo "decalioc-a|1|PENDING|Priority"', 'waiting'; ...
%!              'echo "decalioc-a|1|RUNNING|None"', 'running'; ...
%!              'echo "decalioc-a|1|COMPLETED|None"', 'gone'; ...
%!              'true', 'gone'; 'exit 1', 'unknown'}'
%!   tidy = slurmFake ('false', given{1});
%!   [job, state] = submittedJob (folder);
%!   clear tidy
%!   assert ({job.name, state}, {'decalioc-a', given{2}});
%! end

% SPDX-License-Identifier: GPL-3.0-only
