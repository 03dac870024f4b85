% SLURMCANCEL  Cancels all jobs of a run store that are in the queue of Slurm.
%
% CALL: N = slurmCancel (STORE)
%
%   STORE  folder of the run store (text; the case folder, or Input.store)
%   N      number of arrays that scancel was called for
%
% Finished runs stay. The next start submits what was cancelled again.
%
% Errors: DEcalioc:slurmCancel:runFailed
%
% See also: executeSlurm

function n = slurmCancel (store)
  names = {slurmLedger(store).name};
  n = numel (names);
  if n == 0
    return
  end
  command = ['scancel --user="$(id -u)" --jobname=', ...
             shellQuote(strjoin (names, ',')), ' 2>&1'];
  [status, text] = system (command);
  if status ~= 0
    error ('DEcalioc:slurmCancel:runFailed', ...
           ['slurmCancel: Slurm must cancel the jobs, got: %s. Try again ' ...
            'when the controller answers.'], strtrim (text));
  end
end

%!assert (slurmCancel (tempname ()), 0)
