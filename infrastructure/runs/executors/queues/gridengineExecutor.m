% GRIDENGINEEXECUTOR  What the queue Grid Engine is, its fields and commands.
%
% CALL: QUEUE = gridengineExecutor ()
%
%   QUEUE  scalar struct, see newQueue

function queue = gridengineExecutor ()
  traits.name = 'gridengine';
  traits.title = 'Grid Engine';
  traits.words = {'queue', 'project', 'environment'};
  traits.option = '^-([a-zA-Z_]+)( .*)?$';
  traits.example = '-l mem_free=2G';
  traits.reserved = {'t', 'N', 'wd', 'cwd', 'o', 'e', 'j', 'i', 'S', 'b', ...
                     'V', 'r', 'terse', 'sync', 'now', 'pe', 'q', 'P', ...
                     'help', 'verify', 'shell', 'inherit'};
  traits.isShort = false;
  traits.program = 'qsub';
  traits.task = {'SGE_TASK_ID', 'JOB_ID'};
  traits.start = @askCluster;
  traits.call = @callOf;
  traits.submit = @submit;
  traits.look = @look;
  traits.cancel = @cancel;
  queue = newQueue (traits);
end

% Tasks that one array may have: max_aj_tasks of the global configuration. A
% master that does not answer is waited for later.
function [n, fault] = askCluster ()
  [number, fault] = askQueue ({'qsub', 'qstat'}, 'qconf -sconf', 'SGE_ROOT', ...
                              'max_aj_tasks\s+(\d+)');
  n = 1000;
  if number > 0                          % 0: no limit
    n = number;
  end
end

function [ok, text] = cancel (names)
  names = cellfun (@shellQuote, names, 'UniformOutput', false);
  [~, text] = system (['qdel ', strjoin(names, ' '), ' 2>&1']);
  % an array that has ended is no fault
  ok = isempty (strfind (text, 'qmaster'));
end

function words = callOf (batch, opt, task)
  slots = {};
  named = {'-q', opt.queue; '-P', opt.project}';
  named(:, cellfun ('isempty', named(2, :))) = [];
  if batch.cpu > 1 || ~isempty (opt.environment)
    % the slots of one job on one host: what the environment must be set up for
    slots = {'-pe', givenField(opt, 'environment', 'smp'), ...
             sprintf('%d', batch.cpu)};
  end
  % '-l mem_free=2G' are two words
  extra = regexp (opt.extra, '^(\S+) *(.*)$', 'tokens', 'once');
  extra = strtrim ([cell(1, 0), extra{:}])(:)';
  words = [{'qsub', '-V', '-terse', '-r', 'n', '-j', 'y', ...
            '-S', '/bin/bash', '-wd', '/', '-N', batch.name, '-t', sprintf('1-%d', batch.n), ...
            '-l', sprintf('h_rt=%d', 60 * batch.minutes), ...
            '-o', logName(batch.path)}, named(:)', slots, ...
           extra(~cellfun ('isempty', extra)), task];
end

function [ok, text, isPassing] = submit (batch, opt, task)
  words = cellfun (@shellQuote, callOf (batch, opt, task), ...
                   'UniformOutput', false);
  % a session of its own: Ctrl-C shall not interrupt qsub half-way
  [status, text] = system (['setsid --wait ', strjoin(words, ' '), ...
                            ' 2>&1 < /dev/null']);
  ok = status == 0;
  isPassing = ~isempty (regexp (text, 'commlib|send message', 'once'));
end

% Grid Engine takes $, : and , in a path for signs of its own: no log then.
function name = logName (folder)
  name = [folder, '/$TASK_ID.out'];
  if any (ismember (folder, '$:,'))
    name = '/dev/null';
  end
end

% qstat lists what waits or runs, one element a task. What has ended is not
% there any more: the run's end mark says how, and without one the run was
% killed or cancelled.
function [ok, text, tasks] = look (names, sizes)
  [status, text] = system (['timeout 60 qstat -xml -g d -u "$(id -un)" ' ...
                            '2>&1']);
  ok = status == 0;
  parts = regexp (text, ['<JB_name>([^<]*)</JB_name>.*?<state>([^<]*)', ...
                         '</state>.*?<tasks>([^<]*)</tasks>'], 'tokens');
  parts = vertcat (parts{:}, cell (0, 3));
  tasks = struct ('state', cell (1, numel (names)), 'word', '');
  for k = 1:numel (names)
    tasks(k) = ofArray (parts(strcmp (parts(:, 1), names{k}), 2:3), sizes(k));
  end
end

function tasks = ofArray (parts, n)
  tasks = struct ('state', repmat ('-', 1, n), ...
                  'word', {repmat({'not in qstat any more'}, 1, n)});
  for k = 1:rows (parts)
    t = numbersOf (parts{k, 2});
    t = t(t <= n);
    tasks.state(t) = merge (any (parts{k, 1} == 'q'), 'p', 'r');
    isFault = any (parts{k, 1} == 'E');
    tasks.word(t) = {[parts{k, 1}, repmat(' (see qstat -explain E)', 1, ...
                                          isFault)]};
  end
end

% '7', '2-9:1' or '1,4'
function numbers = numbersOf (text)
  numbers = [];
  for part = strsplit (text, ',')
    ends = sscanf (part{1}, '%d-%d:%d')';
    ends(end + 1:2) = ends(end);
    numbers = [numbers, ends(1):ends(2)];
  end
end

%!test
%! queue = gridengineExecutor ();
%! assert (isempty (queue.check (struct ('queue', 'all.q', 'extra', ...
%!                                      '-l mem_free=2G'))));
%! assert (queue.check (struct ('extra', '-t 1-3')).id, ...
%!         'DEcalioc:checkCase:badQueueExtra');
%! assert (queue.check (struct ('partition', 'a')).id, ...
%!         'DEcalioc:checkCase:unknownField');
%!function [verdict, text] = sendTo (qsub, qstat)
%!  tidy = slurmFake (qsub, qstat, {'qsub', 'qstat'});
%!  batch = struct ('name', 'decalioc-1', 'path', '/a b', 'n', 3, ...
%!                  'cpu', 2, 'minutes', 5);
%!  given.extra = {'-l mem_free=2G', '-notify'};
%!  queue = gridengineExecutor ();
%!  opt = queue.options (struct ('gridengine', given));
%!  opt.queue = 'main';
%!  [verdict, text] = queue.send (batch, opt, {'job.sh', 'it''s $(x)'});
%!endfunction
%!test
%! % every word arrives as it is
%! [verdict, text] = sendTo ('printf "%s|" "$@"', 'true');
%! assert (verdict, 'sent');
%! assert (! isempty (strfind (text, '|-t|1-3|-l|h_rt=300|')));
%! assert (text(end-57:end), ['-q|main|-pe|smp|2|-l|mem_free=2G|-notify|', ...
%!                            'job.sh|it''s $(x)|']);
%!test
%! [verdict, text] = sendTo ('echo "unknown queue" >&2; exit 1', 'true');
%! assert ({verdict, text}, {'refused', 'unknown queue'});
%!assert (sendTo ('echo "commlib error" >&2; exit 1', 'true'), 'later')
%!assert (sendTo ('exit 1', 'exit 1'), 'later')
%!test
%! % qsub gave up, but the master has the job
%! assert (sendTo ('echo "commlib error"; exit 1', ...
%!                 ['printf "<job_list><JB_name>decalioc-1</JB_name>', ...
%!                  '<state>qw</state><tasks>1</tasks></job_list>"']), 'sent');
%!test
%! job = ['<job_list>\n<JB_name>%s</JB_name>\n<state>%s</state>\n', ...
%!        '<tasks>%s</tasks>\n</job_list>\n'];
%! list = [sprintf(job, 'a', 'r', '1'), sprintf(job, 'b', 'r', '1'), ...
%!         sprintf(job, 'a', 'qw', '3-4:1'), sprintf(job, 'a', 'Eqw', '6'), ...
%!         sprintf(job, 'a', 'dr', '7')];
%! tidy = slurmFake ('', ['echo ''', list, ''''], {'qsub', 'qstat'});
%! queue = gridengineExecutor ();
%! [ok, ~, tasks] = queue.look ({'a', 'c'}, [7, 1]);
%! assert (ok);
%! assert ({tasks.state}, {'r-pp-pr', '-'});
%! assert (tasks(1).word{6}, 'Eqw (see qstat -explain E)');
%!test
%! tidy = slurmFake ('', 'echo "no contact" >&2; exit 1', {'qsub', 'qstat'});
%! queue = gridengineExecutor ();
%! [ok, text] = queue.look ({'a'}, 1);
%! assert (! ok);
%! assert (text, "no contact\n");
%!test
%! % a machine that belongs to no cluster: its own words, no path before them
%! tidy = slurmFake ('true', 'true', {'qsub', 'qstat'});
%! say = slurmFake ('echo "set the environment variable SGE_ROOT"; exit 1', ...
%!                  'true', {'qconf', 'qdel'});
%! queue = gridengineExecutor ();
%! [~, fault] = queue.start ();
%! assert (fault, 'set the environment variable SGE_ROOT');

% SPDX-License-Identifier: GPL-3.0-only
