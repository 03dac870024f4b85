% GRIDENGINESEND  Hands a batch over to Grid Engine as one job array.
%
% CALL: [VERDICT, TEXT] = gridengineSend (BATCH, OPT, TASK)
%
%   arguments as in slurmSend

function [verdict, text] = gridengineSend (batch, opt, task)
  words = [{'-V', '-terse', '-r', 'n', '-j', 'y', '-S', '/bin/bash', ...
            '-wd', '/', '-N', batch.name, '-t', sprintf('1-%d', batch.n), ...
            '-l', sprintf('h_rt=%d', 60 * batch.minutes), ...
            '-o', logName(batch.path)}, ...
           named('-q', opt.queue), named('-P', opt.project), ...
           parallel(batch.cpu, opt.environment), split(opt.extra), task];
  words = cellfun (@shellQuote, words, 'UniformOutput', false);
  % a session of its own: Ctrl-C shall not interrupt qsub half-way
  [status, text] = system (['setsid --wait qsub ', strjoin(words, ' '), ...
                            ' 2>&1 < /dev/null']);
  text = strtrim (text);
  verdict = 'sent';
  if status ~= 0
    [ok, ~, tasks] = gridengineLook ({batch.name}, batch.n);
    isThere = ok && any (tasks.state ~= '-');
    if ~ok || (~isThere && ~isempty (regexp (text, 'commlib|send message')))
      verdict = 'later';
    elseif ~isThere
      verdict = 'refused';
    end
  end
end

function words = named (option, value)
  words = {};
  if ~isempty (value)
    words = {option, value};
  end
end

% The slots of one job on one host: what the environment must be set up for.
function words = parallel (cpu, environment)
  words = {};
  if cpu > 1 || ~isempty (environment)
    environment = [environment, repmat('smp', 1, isempty (environment))];
    words = {'-pe', environment, sprintf('%d', cpu)};
  end
end

% '-l mem_free=2G' are two words
function words = split (extra)
  words = cell (1, 0);
  for k = 1:numel (extra)
    [option, value] = strtok (extra{k}, ' ');
    words{end + 1} = option;
    if ~isempty (value)
      words{end + 1} = strtrim (value);
    end
  end
end

% Grid Engine takes $, : and , in a path for signs of its own: no log then.
function name = logName (folder)
  name = [folder, '/$TASK_ID.out'];
  if any (ismember (folder, '$:,'))
    name = '/dev/null';
  end
end

%!function [verdict, text] = sendTo (qsub, qstat)
%!  tidy = slurmFake (qsub, qstat, {'qsub', 'qstat'});
%!  batch = struct ('name', 'decalioc-1', 'path', '/a b', 'n', 3, ...
%!                  'cpu', 2, 'minutes', 5);
%!  given.extra = {'-l mem_free=2G', '-notify'};
%!  opt = gridengineExecutor ().options (struct ('gridengine', given));
%!  opt.queue = 'main';
%!  [verdict, text] = gridengineSend (batch, opt, {'job.sh', 'it''s $(x)'});
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
