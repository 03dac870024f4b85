% BATCHCANCEL  Cancels all jobs of a run store that are in a queue.
%
% CALL: N = batchCancel (STORE, NAME)
%
%   STORE  folder of the run store (text; the case folder, or Input.store)
%   NAME   name of the executor (text), for example 'slurm'
%   N      number of arrays that were cancelled
%
% Finished runs stay. The next start submits what was cancelled again.
%
% Errors: DEcalioc:batchCancel:runFailed
%
% See also: batchExecute

function n = batchCancel (store, name)
  names = {batchLedger(store, name).name};
  n = numel (names);
  if n == 0
    return
  end
  queue = describeExecutor (name);
  [ok, text] = queue.cancel (names);
  if ~ok
    error ('DEcalioc:batchCancel:runFailed', ...
           ['batchCancel: %s must cancel the jobs, got: %s. Try again ' ...
            'when the queue answers.'], queue.title, strtrim (text));
  end
end

%!assert (batchCancel (tempname (), 'slurm'), 0)
