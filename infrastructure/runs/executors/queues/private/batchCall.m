% BATCHCALL  The program that each task of a job array carries out.
%
% CALL: TASK = batchCall (PATH, QUEUE, OPT, ROOT)
%
%   PATH        folder of the array, see batchSubmit (text)
%   QUEUE, OPT  see newQueue
%   ROOT        folder of the toolbox (text)
%   TASK        1 x n cell: batchTask.sh and its arguments
%
% What a job carries out first goes along as one word that a queue hands on as it
% is: not a file beside the runs, to which others may be able to write.

function task = batchCall (path, queue, opt, root)
  inside = fullfile (root, 'infrastructure');
  task = {fullfile(inside, 'runs', 'executors', 'queues', 'batchTask.sh'), path, ...
          fullfile(inside, 'runs', 'process', 'guard.sh'), queue.task{:}};
  if ~isempty (opt.before)
    lines = cellfun (@(line) sprintf ("%s\n[ $? = 0 ] || return\n", line), ...
                     opt.before, 'UniformOutput', false);
    task{end + 1} = base64_encode (uint8 ([lines{:}]));
  end
end

%!test
%! queue = slurmExecutor ();
%! task = batchCall ('/b', queue, struct ('before', {{'a', 'b'}}), '/r');
%! assert (task(2:4), {'/b', '/r/infrastructure/runs/process/guard.sh', ...
%!                     'SLURM_ARRAY_TASK_ID'});
%! [~, text] = system (sprintf ('echo %s | base64 -d', task{6}));
%! assert (text, "a\n[ $? = 0 ] || return\nb\n[ $? = 0 ] || return\n");
%! task = batchCall ('/b', queue, struct ('before', {{}}), '/r');
%! assert (numel (task), 5);

% SPDX-License-Identifier: GPL-3.0-only
