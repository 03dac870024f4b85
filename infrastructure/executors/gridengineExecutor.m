% GRIDENGINEEXECUTOR  What the queue Grid Engine is, its fields and commands.
%
% CALL: WHAT = gridengineExecutor ()
%
%   WHAT  scalar struct, see describeExecutor and batchExecute

function what = gridengineExecutor ()
  own.words = {'queue', 'project', 'environment'};
  own.option = '^-([a-zA-Z_]+)( .*)?$';
  own.example = '-l mem_free=2G';
  own.reserved = {'t', 'N', 'wd', 'cwd', 'o', 'e', 'j', 'i', 'S', 'b', 'V', ...
                  'r', 'terse', 'sync', 'now', 'pe', 'q', 'P', 'help', ...
                  'verify', 'shell', 'inherit'};
  own.isShort = false;
  what = batchExecutor ('gridengine', 'Grid Engine', own);
  what.program = 'qsub';
  what.task = {'SGE_TASK_ID', 'JOB_ID'};
  what.start = @askCluster;
  what.send = @gridengineSend;
  what.look = @gridengineLook;
  what.cancel = @cancel;
end

% Tasks that one array may have: max_aj_tasks of the global configuration. A
% master that does not answer is waited for later.
function [n, fault] = askCluster ()
  n = 1000;
  fault = '';
  [status, text] = system (['command -v qsub && command -v qstat && ' ...
                            'timeout 60 qconf -sconf 2>&1']);
  if isempty (regexp (text, '/qstat\s', 'once'))
    fault = 'no qsub and qstat on the PATH';
  elseif ~isempty (strfind (text, 'SGE_ROOT'))
    fault = strtrim (text);
  end
  found = regexp (text, 'max_aj_tasks\s+(\d+)', 'tokens', 'once');
  if status == 0 && ~isempty (found) && ~strcmp (found{1}, '0')
    n = str2double (found{1});
  end
end

function [ok, text] = cancel (names)
  names = cellfun (@shellQuote, names, 'UniformOutput', false);
  [~, text] = system (['qdel ', strjoin(names, ' '), ' 2>&1']);
  % an array that has ended is no fault
  ok = isempty (strfind (text, 'qmaster'));
end

%!test
%! what = gridengineExecutor ();
%! assert (isempty (what.check (struct ('queue', 'all.q', 'extra', ...
%!                                      '-l mem_free=2G'))));
%! assert (what.check (struct ('extra', '-t 1-3')).id, ...
%!         'DEcalioc:checkCase:badQueueExtra');
%! assert (what.check (struct ('partition', 'a')).id, ...
%!         'DEcalioc:checkCase:unknownField');
