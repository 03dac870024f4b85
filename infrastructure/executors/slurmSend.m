% SLURMSEND  Hands a batch over to Slurm as one job array.
%
% CALL: [VERDICT, TEXT] = slurmSend (BATCH, OPT, TASK)
%
%   BATCH    one element of FLIGHT.batches, see batchAttach
%   OPT      see batchExecutor
%   TASK     1 x n cell, the program that a task runs, and its arguments
%   VERDICT  'sent'; 'later' (the controller cannot be reached: try again);
%            'refused' (partition, account, limits ...)
%   TEXT     what sbatch said
%
% sbatch may give up on a job that the controller did accept. So the queue is
% asked before a batch is called not sent.

function [verdict, text] = slurmSend (batch, opt, task)
  program = [mfilename('fullpath'), '.sh'];
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
  text = strtrim (text);
  verdict = 'sent';
  if status ~= 0
    [ok, queue] = slurmLook ({batch.name}, batch.n);
    if ~ok || (isempty (strfind (queue, batch.name)) && isPassing (text))
      verdict = 'later';
    elseif isempty (strfind (queue, batch.name))
      verdict = 'refused';
    end
  end
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

function yes = isPassing (text)
  signs = ['contact slurm controller|timed out|temporarily|standby|' ...
           'not connected|onnection|Zero Bytes|Unexpected message|uthentic'];
  yes = ~isempty (regexp (text, signs, 'once'));
end

%!function [verdict, text] = sendTo (sbatch, squeue)
%!  tidy = slurmFake (sbatch, squeue);
%!  batch = struct ('name', 'decalioc-1', 'path', tempname (), 'n', 3, ...
%!                  'cpu', 2, 'minutes', 5);
%!  mkdir (batch.path);
%!  given.extra = {'--comment=it''s; $(x) 100%'};
%!  opt = slurmExecutor ().options (struct ('slurm', given));
%!  [verdict, text] = slurmSend (batch, opt, {'job.sh', 'it''s'});
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
