% SLURMEXECUTOR  What the queue Slurm is, its fields and its commands.
%
% CALL: WHAT = slurmExecutor ()
%
%   WHAT  scalar struct, see describeExecutor and batchExecute

function what = slurmExecutor ()
  own.words = {'partition', 'account'};
  own.option = '^--([a-z][a-z0-9-]*)(=.*)?$';
  own.example = '--mem=2G';
  own.reserved = {'array', 'job-name', 'wrap', 'wait', 'requeue', ...
                  'no-requeue', 'output', 'error', 'input', 'chdir', ...
                  'parsable', 'test-only', 'help', 'usage', 'version', ...
                  'time', 'ntasks', 'nodes', 'cpus-per-task', 'clusters', ...
                  'uid', 'open-mode', 'export'};
  own.isShort = true;
  what = batchExecutor ('slurm', 'Slurm', own);
  what.program = 'sbatch';
  what.task = {'SLURM_ARRAY_TASK_ID', 'SLURM_ARRAY_JOB_ID'};
  what.start = @askCluster;
  what.send = @slurmSend;
  what.look = @slurmLook;
  what.cancel = @cancel;
end

% Tasks that one array may have: the highest index is one less than Slurm's
% MaxArraySize. A controller that does not answer is waited for later.
function [n, fault] = askCluster ()
  n = 1000;
  fault = '';
  [status, text] = system (['command -v sbatch && command -v squeue && ' ...
                            'timeout 60 scontrol show config 2>&1']);
  isAbsent = isempty (regexp (text, '/squeue\s', 'once'));
  if isAbsent
    fault = 'no sbatch and squeue on the PATH';
  elseif ~isempty (strfind (text, 'configuration source'))
    fault = strtrim (text);
  end
  found = regexp (text, 'MaxArraySize\s*=\s*(\d+)', 'tokens', 'once');
  if status == 0 && ~isempty (found)
    n = max (1, str2double (found{1}) - 1);
  end
end

function [ok, text] = cancel (names)
  [status, text] = system (['scancel --user="$(id -u)" --jobname=', ...
                            shellQuote(strjoin (names, ',')), ' 2>&1']);
  ok = status == 0;
end

%!test
%! what = slurmExecutor ();
%! assert (isempty (what.check (struct ('account', 'a'))));
%! assert (what.check (struct ('extra', '--array=1-3')).id, ...
%!         'DEcalioc:checkCase:badQueueExtra');
%! assert (what.sets (struct ('slurm', struct ('sets', 3))), 3);
%! assert (what.sets (struct ()), 8);
