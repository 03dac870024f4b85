% SLURMSEND  Hands a batch over to Slurm as one job array.
%
% CALL: [VERDICT, TEXT] = slurmSend (BATCH, OPT, ROOT)
%
%   BATCH    one element of FLIGHT.batches, see slurmSubmit
%   OPT      see slurmOptions
%   ROOT     folder of the toolbox (text)
%   VERDICT  'sent'; 'later' (the controller cannot be reached: try again);
%            'refused' (partition, account, limits ...)
%   TEXT     what sbatch said
%
% sbatch may give up on a job that the controller did accept. So the queue is
% asked before a batch is called not sent.
%
% See also: slurmSubmit, slurmSubmit.sh

function [verdict, text] = slurmSend (batch, opt, root)
  here = fullfile (root, 'infrastructure', 'executors');
  guard = fullfile (root, 'infrastructure', 'runs', 'guard.sh');
  words = [{fullfile(here, 'slurmSubmit.sh'), batch.path}, opt.extra, ...
           named('partition', opt.partition), ...
           named('account', opt.account), ...
           {['--job-name=', batch.name], '--no-requeue', '--export=ALL', ...
            '--nodes=1', sprintf('--ntasks=%d', batch.cpu), ...
            '--cpus-per-task=1', sprintf('--time=%d', batch.minutes), ...
            sprintf('--array=1-%d', batch.n), ['--chdir=', batch.path], ...
            ['--output=', logName(batch.path)], ...
            fullfile(here, 'slurmTask.sh'), batch.path, guard}];
  words = cellfun (@shellQuote, words, 'UniformOutput', false);
  % a session of its own: Ctrl-C shall not interrupt sbatch half-way
  [status, text] = system (['setsid --wait bash ', strjoin(words, ' ')]);
  text = strtrim (text);
  verdict = 'sent';
  if status ~= 0
    [ok, queue] = slurmQueue ({batch.name});
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
