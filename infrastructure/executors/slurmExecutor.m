% SLURMEXECUTOR  What the queue Slurm is, its fields and its commands.
%
% CALL: QUEUE = slurmExecutor ()
%
%   QUEUE  scalar struct, see newQueue

function queue = slurmExecutor ()
  own.name = 'slurm';
  own.title = 'Slurm';
  own.words = {'partition', 'account'};
  own.option = '^--([a-z][a-z0-9-]*)(=.*)?$';
  own.example = '--mem=2G';
  own.reserved = {'array', 'job-name', 'wrap', 'wait', 'requeue', ...
                  'no-requeue', 'output', 'error', 'input', 'chdir', ...
                  'parsable', 'test-only', 'help', 'usage', 'version', ...
                  'time', 'ntasks', 'nodes', 'cpus-per-task', 'clusters', ...
                  'uid', 'open-mode', 'export'};
  own.isShort = true;
  own.program = 'sbatch';
  own.task = {'SLURM_ARRAY_TASK_ID', 'SLURM_ARRAY_JOB_ID'};
  own.start = @askCluster;
  own.submit = @submit;
  own.look = @slurmLook;
  own.cancel = @cancel;
  queue = newQueue (own);
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

function [ok, text, isPassing] = submit (batch, opt, task)
  program = fullfile (fileparts (mfilename ('fullpath')), 'slurmSend.sh');
  words = [{program, batch.path}, opt.extra, ...
           named('partition', opt.partition), ...
           named('account', opt.account), ...
           {['--job-name=', batch.name], '--no-requeue', '--export=ALL', ...
            '--nodes=1', sprintf('--ntasks=%d', batch.cpu), ...
            '--cpus-per-task=1', sprintf('--time=%d', batch.minutes), ...
            sprintf('--array=1-%d', batch.n), ['--chdir=', batch.path], ...
            ['--output=', logName(batch.path)]}, task];
  words = cellfun (@shellQuote, words, 'UniformOutput', false);
  % a session of its own: Ctrl-C shall not interrupt sbatch half-way
  [status, text] = system (['setsid --wait bash ', strjoin(words, ' ')]);
  ok = status == 0;
  signs = ['contact slurm controller|timed out|temporarily|standby|' ...
           'not connected|onnection|Zero Bytes|Unexpected message|uthentic'];
  isPassing = ~isempty (regexp (text, signs, 'once'));
end

function words = named (option, value)
  words = {};
  if ~isempty (value)
    words = {sprintf('--%s=%s', option, value)};
  end
end

% Slurm takes % and \ in the whole path for patterns: no log then.
function name = logName (folder)
  name = '%a.out';
  if any (ismember (folder, '%\'))
    name = '/dev/null';
  end
end

%!test
%! queue = slurmExecutor ();
%! assert (isempty (queue.check (struct ('account', 'a'))));
%! assert (queue.check (struct ('extra', '--array=1-3')).id, ...
%!         'DEcalioc:checkCase:badQueueExtra');
%! assert (queue.sets (struct ('slurm', struct ('sets', 3))), 3);
%! assert (queue.sets (struct ()), 8);
%!function [verdict, text] = sendTo (sbatch, squeue)
%!  tidy = slurmFake (sbatch, squeue);
%!  batch = struct ('name', 'decalioc-1', 'path', tempname (), 'n', 3, ...
%!                  'cpu', 2, 'minutes', 5);
%!  mkdir (batch.path);
%!  given.extra = {'--comment=it''s; $(x) 100%'};
%!  queue = slurmExecutor ();
%!  opt = queue.options (struct ('slurm', given));
%!  [verdict, text] = queue.send (batch, opt, {'job.sh', 'it''s'});
%!  id = fullfile (batch.path, 'id');
%!  if isfile (id)
%!    text = fileread (id);
%!  end
%!  confirm_recursive_rmdir (false, 'local');
%!  rmdir (batch.path, 's');
%!endfunction
%!test
%! % every word arrives as it is; what a surrounding job has set does not
%! setenv ('SLURM_NTASKS', '7');
%! [verdict, text] = sendTo ('printf "%s\n" "$@" $SLURM_NTASKS', 'true');
%! unsetenv ('SLURM_NTASKS');
%! assert (verdict, 'sent');
%! words = strsplit (strtrim (text), "\n");
%! assert (words{2}, '--comment=it''s; $(x) 100%');
%! assert (all (ismember ({'--array=1-3', '--ntasks=2', '--time=5', ...
%!                         '--job-name=decalioc-1'}, words)));
%! assert (words(end - 1:end), {'job.sh', 'it''s'});
%!test
%! [verdict, text] = sendTo ('echo "invalid partition" >&2; exit 1', 'true');
%! assert ({verdict, text}, {'refused', 'invalid partition'});
%!assert (sendTo ('echo "Socket timed out" >&2; exit 1', 'true'), 'later')
%!assert (sendTo ('exit 1', 'echo "no contact"; exit 1'), 'later')
%!test
%! % sbatch gave up, but the controller has the job
%! assert (sendTo ('echo "Socket timed out" >&2; exit 1', ...
%!                 'echo "decalioc-1|1|PENDING|None"'), 'sent');
