% SLURMEXECUTOR  What the queue Slurm is, its fields and its commands.
%
% CALL: QUEUE = slurmExecutor ()
%
%   QUEUE  scalar struct, see newQueue

function queue = slurmExecutor ()
  traits.name = 'slurm';
  traits.title = 'Slurm';
  traits.words = {'partition', 'account'};
  traits.option = '^--([a-z][a-z0-9-]*)(=.*)?$';
  traits.example = '--mem=2G';
  traits.reserved = {'array', 'job-name', 'wrap', 'wait', 'requeue', ...
                     'no-requeue', 'output', 'error', 'input', 'chdir', ...
                     'parsable', 'test-only', 'help', 'usage', 'version', ...
                     'time', 'ntasks', 'nodes', 'cpus-per-task', 'clusters', ...
                     'uid', 'open-mode', 'export'};
  traits.isShort = true;
  traits.program = 'sbatch';
  traits.task = {'SLURM_ARRAY_TASK_ID', 'SLURM_ARRAY_JOB_ID'};
  traits.start = @askCluster;
  traits.call = @callOf;
  traits.submit = @submit;
  traits.look = @look;
  traits.cancel = @cancel;
  queue = newQueue (traits);
end

% Tasks that one array may have: the highest index is one less than Slurm's
% MaxArraySize. A controller that does not answer is waited for later.
function [n, fault] = askCluster ()
  [number, fault] = askQueue ({'sbatch', 'squeue'}, 'scontrol show config', ...
                              'configuration source', 'MaxArraySize\s*=\s*(\d+)');
  n = 1000;
  if ~isnan (number)
    n = max (1, number - 1);
  end
end

function [ok, text] = cancel (names)
  [status, text] = system (['scancel --user="$(id -u)" --jobname=', ...
                            shellQuote(strjoin (names, ',')), ' 2>&1']);
  ok = status == 0;
end

function words = callOf (batch, opt, task)
  named = {'--partition=', opt.partition; '--account=', opt.account};
  named(cellfun ('isempty', named(:, 2)), :) = [];
  words = [{'sbatch', '--parsable'}, opt.extra, ...
           strcat(named(:, 1), named(:, 2))', ...
           {['--job-name=', batch.name], '--no-requeue', '--export=ALL', ...
            '--nodes=1', sprintf('--ntasks=%d', batch.cpu), ...
            '--cpus-per-task=1', sprintf('--time=%d', batch.minutes), ...
            sprintf('--array=1-%d', batch.n), ['--chdir=', batch.path], ...
            ['--output=', logName(batch.path)]}, task];
end

function [ok, text, isPassing] = submit (batch, opt, task)
  words = cellfun (@shellQuote, callOf (batch, opt, task), ...
                   'UniformOutput', false);
  % variables of a job in which Octave itself may be running would be taken as
  % options of the new one
  script = ['for name in "${!SLURM_@}"; do [ $name = SLURM_CONF ] || ' ...
            'unset $name; done; exec sbatch "$@" 2>&1 < /dev/null'];
  % a session of its own: Ctrl-C shall not interrupt sbatch half-way
  [status, text] = system (['setsid --wait bash -c ', shellQuote(script), ...
                            ' ', strjoin(words, ' ')]);
  ok = status == 0;
  signs = ['contact slurm controller|timed out|temporarily|standby|' ...
           'not connected|onnection|Zero Bytes|Unexpected message|uthentic'];
  isPassing = ~isempty (regexp (text, signs, 'once'));
end

% Slurm takes % and \ in the whole path for patterns: no log then.
function name = logName (folder)
  name = '%a.out';
  if any (ismember (folder, '%\'))
    name = '/dev/null';
  end
end

% Arrays are asked for by name, not by number: an unknown number is an error
% for squeue, an unknown name is not. Ended jobs are listed as long as the
% controller remembers them (MinJobAge).
function [ok, text, tasks] = look (names, sizes)
  command = ['timeout 60 squeue --noheader --array --states=all ' ...
             '--user="$(id -u)" --format="%j|%K|%T|%r" --name='];
  [status, text] = system ([command, shellQuote(strjoin (names, ',')), ...
                            ' 2>&1']);
  ok = status == 0;
  tasks = struct ('state', cell (1, numel (names)), 'word', '');
  for k = 1:numel (names)
    tasks(k) = ofArray (text, names{k}, sizes(k));
  end
end

% A line of squeue may stand for several tasks ('7', '2-5,9', '2-8%3'), 'N/A'
% (cancelled before the array was split up) for all not listed. A task that is
% listed twice (submitted twice, see batchTask.sh) has the state of the one that
% has not ended; what a future Slurm invents is running.
function tasks = ofArray (text, name, n)
  lines = regexp (text, '^([^|\n]+)\|([^|\n]*)\|([^|\n]*)\|([^\n]*)$', ...
                  'tokens', 'lineanchors');
  lines = vertcat (lines{:}, cell (0, 4));
  lines = lines(strcmp (lines(:, 1), name), 2:4);
  % what is written later counts: live tasks come last
  isLive = ismember (cellfun (@letterOf, lines(:, 2)), 'pr');
  [~, order] = sort (2 * isLive(:) - strcmp (lines(:, 1), 'N/A'));
  tasks = struct ('state', repmat ('-', 1, n), 'word', {repmat({''}, 1, n)});
  for line = lines(order, :)'
    t = taskNumbers (line{1}, n);
    tasks.state(t) = letterOf (line{2});
    isSaid = ~any (strcmp (line{3}, {'', 'None'}));
    tasks.word(t) = {[line{2}, repmat([' (', line{3}, ')'], 1, isSaid)]};
  end
end

function letter = letterOf (state)
  known = {'TIMEOUT', 'DEADLINE', 'PENDING', 'BOOT_FAIL', 'CANCELLED', ...
           'COMPLETED', 'FAILED', 'NODE_FAIL', 'OUT_OF_MEMORY', ...
           'PREEMPTED', 'REVOKED'};
  letters = 'ttpeeeeeeeer';
  letter = letters(find ([strcmp(state, known), true], 1));
end

function tasks = taskNumbers (text, n)
  tasks = 1:n;
  if ~strcmp (text, 'N/A')
    listed = [];
    for part = strsplit (regexprep (text, '%.*$|[\[\]]', ''), ',')
      ends = sscanf (part{1}, '%d-%d');
      listed = [listed, min(ends):max(ends)];
    end
    tasks = intersect (tasks, listed);
  end
end

%!test
%! queue = slurmExecutor ();
%! assert (isempty (queue.check (struct ('account', 'a'))));
%! assert (queue.check (struct ('extra', '--array=1-3')).id, ...
%!         'DEcalioc:checkCase:badQueueExtra');
%! assert (queue.sets (struct ('slurm', struct ('sets', 3))), 3);

%!function [verdict, text] = sendTo (sbatch, squeue)
%!  tidy = slurmFake (sbatch, squeue);
%!  batch = struct ('name', 'decalioc-1', 'path', '/a b', 'n', 3, ...
%!                  'cpu', 2, 'minutes', 5);
%!  given.extra = {'--comment=it''s; $(x) 100%'};
%!  queue = slurmExecutor ();
%!  opt = queue.options (struct ('slurm', given));
%!  [verdict, text] = queue.send (batch, opt, {'job.sh', 'it''s'});
%!endfunction
%!test
%! % every word arrives as it is; what a surrounding job has set does not
%! setenv ('SLURM_NTASKS', '7');
%! [verdict, text] = sendTo ('printf "%s\n" "$@" $SLURM_NTASKS', 'true');
%! unsetenv ('SLURM_NTASKS');
%! assert (verdict, 'sent');
%! words = strsplit (text, "\n");
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

%!test
%! tidy = slurmFake ('false', 'echo "$@"');
%! queue = slurmExecutor ();
%! [ok, text] = queue.look ({'a', 'b'}, [1, 1]);
%! assert (ok && ! isempty (strfind (text, '--name=a,b')));
%! clear tidy
%! tidy = slurmFake ('false', 'echo "no contact" >&2; exit 1');
%! [ok, text] = queue.look ({'a'}, 1);
%! assert ({ok, text}, {false, "no contact\n"});

%!function [states, words] = parsed (text, n)
%!  tidy = slurmFake ('false', sprintf ("cat <<'END'\n%sEND", text));
%!  queue = slurmExecutor ();
%!  [~, ~, tasks] = queue.look ({'a'}, n);
%!  states = tasks.state;
%!  words = tasks.word;
%!endfunction
%!test
%! text = sprintf (["a|1|RUNNING|None\nb|1|FAILED|NonZeroExitCode\n", ...
%!                  "a|3-4|CANCELLED|None\na|[6-8%%2]|PENDING|Priority\n"]);
%! [s, w] = parsed (text, 8);
%! assert (s, 'r-ee-ppp');
%! assert (w([1, 2, 6]), {'RUNNING', '', 'PENDING (Priority)'});
%! % nothing; cancelled before it was split, one task had run before; submitted
%! % twice: the one that goes on counts
%! for c = {'', '---'; "a|1|COMPLETING|None\n", 'r--'; ...
%!          "a|2|TIMEOUT|None\na|N/A|CANCELLED|JobHeldUser\n", 'ete'; ...
%!          "a|1|RUNNING|None\na|1|FAILED|NonZeroExitCode\n", 'r--'; ...
%!          "a|1|FAILED|NonZeroExitCode\na|1|PENDING|None\n", 'p--'}'
%!   assert (parsed (c{1}, 3), c{2});
%! end
%!test
%! % a machine that belongs to no cluster: Slurm's own words, no path before them
%! tidy = slurmFake ('true', 'true');
%! say = slurmFake ('echo "fatal: no configuration source"; exit 1', 'true', ...
%!                  {'scontrol', 'scancel'});
%! queue = slurmExecutor ();
%! [~, fault] = queue.start ();
%! assert (fault, 'fatal: no configuration source');

% SPDX-License-Identifier: GPL-3.0-only
